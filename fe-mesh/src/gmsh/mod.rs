//! The gmsh format, versions 2.2 and 4.1, ASCII and binary: bytes in, mesh out.
