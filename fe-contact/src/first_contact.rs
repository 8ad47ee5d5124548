//! The first contact of a body that contact alone holds.
