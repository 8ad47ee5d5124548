//! Which facets may meet: a grid of boxes.
