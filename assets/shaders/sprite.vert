#version 450 core
// One instance = one SpriteVertex (render/sprite_vertex.h); its quad hugs the shape and the glow round it.

layout(location = 0) in vec4 places;     // x, y at the end of the tick; x, y one tick earlier
layout(location = 1) in vec2 angleSize;  // heading in radians, half extent in metres
layout(location = 2) in uvec2 look;      // shape, flags, energy, age; colour 0xRRGGBB

layout(location = 0) uniform vec4 camera;     // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 view;       // share of the tick passed; ticks so far; pixels per metre; brightness
layout(location = 2) uniform vec4 light;      // glow: reach as a share of the shape, most pixels, strength; flashes wanted

out vec2 at;                       // place in the shape's own units: its half extent is 1, +x its heading
flat out vec4 edge0, edge1, edge2; // a point on each edge, and the edge's direction
flat out vec4 edges;               // lengths of the three edges; pixels per unit
flat out vec4 kind;                // fold of x; fold of the diagonal; roundness; chequers
flat out vec4 rings;               // outer radius (0: not a ring), inner radius; half line width, glow reach in pixels
flat out vec4 tint;                // colour; how strongly the inside covers what lies below
flat out vec3 lit;                 // brightness of fill, of line, of glow

// A shape is what remains of it after folding along its mirror lines: at most three edges, counter-clockwise,
// inside to their left. kFold: x by its mirror, then by the diagonal; corner rounding; chequers.
//
//   y |  ,/|   a star, folded twice,
//     | /__\_  is one edge: from its
//     +------x tip to its notch
//
// 0 triangle, 1 square, 2 hexagon, 3 dart, 4 chequered square, 5 star, 6 double ring, 7 shot, 8 bit, 9 ship
const int kShapes = 10;
const vec4 kNone = vec4(50, 49, 49, 50);  // an edge so far outside that it never matters
const vec4 kEdges[kShapes * 3] = vec4[](
  vec4(1, 0, -.62, .92), vec4(-.62, .92, -.62, 0), kNone,
  vec4(1, 0, 1, 1), kNone, kNone,
  vec4(1, 0, .5, .866), vec4(.5, .866, 0, .866), kNone,
  vec4(1, 0, -.9, .66), vec4(-.9, .66, -.38, 0), kNone,
  vec4(1, 0, 1, 1), kNone, kNone,
  vec4(1.1, 0, .3, .3), kNone, kNone,
  kNone, kNone, kNone,
  vec4(.82, 0, 0, 0), kNone, kNone,
  vec4(1, 0, .5, .5), kNone, kNone,
  vec4(-.05, 0, 1, .34), vec4(1, .34, -.7, 1), vec4(-.7, 1, -.38, 0));
const vec4 kFold[kShapes] = vec4[](
  vec4(0, 0, 0, 0), vec4(1, 1, 0, 0), vec4(1, 0, 0, 0), vec4(0, 0, 0, 0), vec4(1, 1, 0, 1),
  vec4(1, 1, 0, 0), vec4(0, 0, 0, 0), vec4(1, 0, .18, 0), vec4(1, 1, 0, 0), vec4(0, 0, 0, 0));
// Extent: smallest x, largest x, largest |y|; width of the line.
const vec4 kExtent[kShapes] = vec4[](
  vec4(-.62, 1, .92, 1), vec4(-1, 1, 1, 1), vec4(-1, 1, .866, 1.7), vec4(-.9, 1, .66, 1), vec4(-1, 1, 1, .8),
  vec4(-1.1, 1.1, 1.1, 1), vec4(-1, 1, 1, .85), vec4(-1, 1, .18, 1), vec4(-1, 1, 1, .8), vec4(-.7, 1, 1, 1.25));
// Fill when full of energy, fill when spent; how strongly the inside covers; whether the shape turns with its
// heading (an upright rectangle is what collides, so that is what is shown).
const vec4 kFill[kShapes] = vec4[](
  vec4(.26, .04, .75, 1), vec4(.22, .04, .75, 0), vec4(.34, .03, .85, 1), vec4(.40, .05, .6, 1), vec4(.75, .10, .75, 0),
  vec4(.36, .04, .75, 1), vec4(.24, .03, .75, 1), vec4(.9, .9, .5, 1), vec4(.55, .55, .3, 0), vec4(.16, .16, .85, 1));
// Radii of the outer and the inner ring; how much further than others' its glow reaches (so that one finds oneself).
const vec3 kRings[kShapes] = vec3[](
  vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1),
  vec3(0, 0, 1), vec3(1, .5, 1), vec3(0, 0, 1.2), vec3(0, 0, 1), vec3(0, 0, 2.2));

const float kAnnounced_ticks = 30;  // World::announced_ticks as the rules start from it: when the outline arrives
const float kAnnouncedScale = 2;    // and how much larger than the shape it starts

vec4 edgeOf(vec4 ends) { return vec4(ends.xy, normalize(ends.zw - ends.xy)); }

void main() {
  int shape = min(int(look.x & 255u), kShapes - 1);
  bool announced = (look.x & 0x100u) != 0u;
  bool damaged = (look.x & 0x200u) != 0u;
  bool untouchable = (look.x & 0x400u) != 0u;
  float energy = float((look.x >> 16) & 255u) / 255.0;
  float age_ticks = float(look.x >> 24);

  float size_m = angleSize.y;
  tint = vec4(unpackUnorm4x8(look.y).zyx, kFill[shape].z);
  lit = vec3(mix(kFill[shape].y, kFill[shape].x, energy), 1, light.z);
  float lineWidth = kExtent[shape].w;

  if (announced) {
    float done = clamp((age_ticks - 1 + view.x) / kAnnounced_ticks, 0.0, 1.0);
    size_m *= 1 + kAnnouncedScale * (1 - done) * (1 - done);
    lit = vec3(0, .25 + .55 * done, .3 * light.z);
    tint.w = 0;
    lineWidth = min(lineWidth, .6);
  }
  if (damaged) {
    tint.rgb = light.w > .5 ? mix(tint.rgb, vec3(1), .85) : mix(tint.rgb, vec3(1), .3);
    lit.x = light.w > .5 ? .6 : lit.x + .15;
  }
  if (untouchable) {
    float on = light.w > .5 ? float(fract(view.y / 10) < .5) : .5;
    lit *= mix(.25, 1, on);
  }
  lit *= view.w;

  float unit_px = size_m * view.z;
  float reach_px = min(light.x * unit_px, light.y) * kRings[shape].z;
  edge0 = edgeOf(kEdges[shape * 3]);
  edge1 = edgeOf(kEdges[shape * 3 + 1]);
  edge2 = edgeOf(kEdges[shape * 3 + 2]);
  edges = vec4(distance(kEdges[shape * 3].xy, kEdges[shape * 3].zw),
               distance(kEdges[shape * 3 + 1].xy, kEdges[shape * 3 + 1].zw),
               distance(kEdges[shape * 3 + 2].xy, kEdges[shape * 3 + 2].zw), unit_px);
  kind = kFold[shape];
  rings = vec4(kRings[shape].xy, clamp(.075 * unit_px, .55, 1.6) * lineWidth, max(reach_px, 1));

  // Strip order: lower left, lower right, upper left, upper right; one more pixel for the soft edge.
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  float pad = (reach_px + 1) / unit_px;
  at = vec2(mix(kExtent[shape].x - pad, kExtent[shape].y + pad, corner.x),
            (corner.y * 2 - 1) * (kExtent[shape].z + pad));
  vec2 heading = kFill[shape].w > .5 ? vec2(cos(angleSize.x), sin(angleSize.x)) : vec2(1, 0);
  vec2 place = mix(places.zw, places.xy, view.x);
  place += (at.x * heading + at.y * vec2(-heading.y, heading.x)) * size_m;
  gl_Position = vec4((place - camera.xy) * camera.zw, 0, 1);
}
