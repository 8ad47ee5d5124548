// Two blocks of the same section, one on the other, a quarter of each; their meshes do not match.
//
//   gmsh -3 blocks.geo -o blocks.msh

SetFactory("OpenCASCADE");

width = 4;
interface = 2;
height = 5;
Box(1) = {0, 0, 0, width, width, interface};
Box(2) = {0, 0, interface, width, width, height - interface};

// Four elements along each edge of the lower block, three along each of the upper.
lower() = Unique(Abs(Boundary{ Boundary{ Volume{1}; } }));
upper() = Unique(Abs(Boundary{ Boundary{ Volume{2}; } }));
Transfinite Curve{lower()} = 5;
Transfinite Curve{upper()} = 4;
Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};

tiny = 1e-3;
Physical Volume("LOWER") = {1};
Physical Volume("UPPER") = {2};
Physical Surface("XSYM") = Surface In BoundingBox{-tiny, -tiny, -tiny, tiny, width + tiny, height + tiny};
Physical Surface("YSYM") = Surface In BoundingBox{-tiny, -tiny, -tiny, width + tiny, tiny, height + tiny};
Physical Surface("BOTTOM") = Surface In BoundingBox{-tiny, -tiny, -tiny, width + tiny, width + tiny, tiny};
Physical Surface("TOP") = Surface In BoundingBox{-tiny, -tiny, height - tiny, width + tiny, width + tiny, height + tiny};
middle() = Surface In BoundingBox{-tiny, -tiny, interface - tiny, width + tiny, width + tiny, interface + tiny};
Physical Surface("SECONDARY") = {middle(0)};
Physical Surface("MAIN") = {middle(1)};

Mesh.MshFileVersion = 4.1;
Mesh.Binary = 0;
