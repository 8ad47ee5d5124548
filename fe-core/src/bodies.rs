//! Bodies: connected elements, and the rigid motions that supports leave them.
