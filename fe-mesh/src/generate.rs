//! Generated meshes: blocks of every kind of cell.
