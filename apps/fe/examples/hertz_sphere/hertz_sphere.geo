// An elastic ball on an elastic block: a quarter of the lower half ball (two planes of symmetry) touches the block
// in the origin; z points up. Second-order tetrahedra, their edges a/n long at the contact and longer in proportion
// to the distance from it.
//
//   gmsh -3 hertz_sphere.geo -setnumber n 8 -o hertz_sphere.msh

SetFactory("OpenCASCADE");

DefineConstant[
  n = {8, Name "edges along the contact radius"}
  radius = {10, Name "radius of the ball [L]"}
  contact_radius = {0.5, Name "contact radius a foreseen, after Hertz [L]"}
  width = {15, Name "half width of the block [L]"}
  depth = {12, Name "depth of the block [L]"}
  growth = {0.3, Name "growth of the edge length with the distance, for n = 8"}
];

// A ball around the origin cuts out what may touch, 1.6 a wide; the rest of each body adjoins it.
reach = 1.6 * contact_radius;

// The pole of the sphere's parametrization is turned away from the contact.
Sphere(1) = {0, 0, 0, radius, 0, Pi / 2, Pi / 2};
Rotate { {0, 1, 0}, {0, 0, 0}, Pi / 2 } { Volume{1}; }
Translate {0, 0, radius} { Volume{1}; }
Sphere(2) = {0, 0, 0, reach, 0, Pi / 2, Pi / 2};
inner() = BooleanIntersection{ Volume{1}; }{ Volume{2}; };
outer() = BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; };
ball() = BooleanFragments{ Volume{inner()}; Delete; }{ Volume{outer()}; Delete; };

Box(11) = {0, 0, -depth, width, width, depth};
Sphere(12) = {0, 0, 0, reach, -Pi / 2, 0, Pi / 2};
inner() = BooleanIntersection{ Volume{11}; }{ Volume{12}; };
outer() = BooleanDifference{ Volume{11}; Delete; }{ Volume{12}; Delete; };
block() = BooleanFragments{ Volume{inner()}; Delete; }{ Volume{outer()}; Delete; };

// Faces are found by where they lie. Between the bodies: the two that touch, one flat, one round.
tiny = 1e-3;
x_faces() = Surface In BoundingBox{-tiny, -tiny, -depth - tiny, tiny, width + tiny, radius + tiny};
y_faces() = Surface In BoundingBox{-tiny, -tiny, -depth - tiny, width + tiny, tiny, radius + tiny};
top_faces() = Surface In BoundingBox{-tiny, -tiny, radius - tiny, width + tiny, width + tiny, radius + tiny};
bottom_faces() = Surface In BoundingBox{-tiny, -tiny, -depth - tiny, width + tiny, width + tiny, -depth + tiny};
flat_faces() = Surface In BoundingBox{-tiny, -tiny, -tiny, reach + tiny, reach + tiny, tiny};
round_faces() = Surface In BoundingBox{-tiny, -tiny, -tiny, reach + tiny, reach + tiny, reach^2 / radius};
round_faces() -= flat_faces();

Physical Volume("BALL") = ball();
Physical Volume("BLOCK") = block();
Physical Surface("CONTACT_BALL") = round_faces();
Physical Surface("CONTACT_BLOCK") = flat_faces();
Physical Surface("TOP") = top_faces();
Physical Surface("BOTTOM") = bottom_faces();
Physical Surface("XSYM") = x_faces();
Physical Surface("YSYM") = y_faces();

// Edges a/n up to 1.4 a from the origin, from there growing with the distance; all in proportion to 1/n.
touching() = Point In BoundingBox{-tiny, -tiny, -tiny, tiny, tiny, tiny};
far = radius + width + depth;
Field[1] = Distance;
Field[1].PointsList = {touching()};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].DistMin = 1.4 * contact_radius;
Field[2].DistMax = far;
Field[2].SizeMin = contact_radius / n;
Field[2].SizeMax = contact_radius / n + 8 / n * growth * (far - 1.4 * contact_radius);
Background Field = 2;

Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm3D = 1;
Mesh.Optimize = 1;
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
