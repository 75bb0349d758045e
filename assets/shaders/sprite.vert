#version 450 core
// One instance = one SpriteVertex (render/sprite_vertex.h); its quad hugs the shape and the glow round it.

layout(location = 0) in vec4 places;     // x, y at the end of the tick; x, y one tick earlier
layout(location = 1) in vec2 angleSize;  // heading in radians, half extent in metres
layout(location = 2) in uvec2 look;      // shape, flags, energy, age; colour 0xRRGGBB

layout(location = 0) uniform vec4 camera;     // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 view;       // share of the tick passed; ticks so far; pixels per metre; brightness
layout(location = 2) uniform vec4 light;      // glow: reach as a share of the shape, most pixels, strength; flashes wanted

out vec2 at;                        // place in the shape's own units: its half extent is 1, +x its heading
flat out vec3 side0, side1, side2;  // sides of the folded shape: outward normal, distance from the middle
flat out vec3 kind;                 // fold; chequers; radius of an inner ring, or 0
flat out vec4 scale;                // pixels per unit; half line width and glow reach in pixels; radius of the whole
flat out vec4 tint;                 // colour; how strongly the inside covers what lies below
flat out vec3 lit;                  // brightness of fill, of line, of glow

// A shape is what remains of it after folding along its mirror lines: the inside of at most three sides. Folding
// is always along the heading (y), from 1 on also across it (x), and 2 along the diagonal as well.
//
//   y |  /.|   a star, folded twice, is
//     | /.  *   one side: from its tip
//     +------x  to its notch
//
// 0 triangle, 1 square, 2 hexagon, 3 dart, 4 chequered square, 5 star, 6 double ring, 7 shot, 8 bit, 9 ship
const int kShapes = 10;
// From one corner to the next, counter-clockwise, so that the inside is to the left.
#define NORMAL(ax, ay, bx, by) normalize(vec2((by) - (ay), (ax) - (bx)))
#define SIDE(ax, ay, bx, by) vec3(NORMAL(ax, ay, bx, by), dot(NORMAL(ax, ay, bx, by), vec2(ax, ay)))
const vec3 kNone = vec3(0, 0, 9);  // a side so far away that everything is inside
const vec3 kSides[kShapes * 3] = vec3[](
  SIDE(1, 0, -.62, .92), SIDE(-.62, .92, -.62, 0), kNone,
  SIDE(1, 0, 1, 1), kNone, kNone,
  SIDE(1, 0, .5, .866), SIDE(.5, .866, 0, .866), kNone,
  SIDE(1, 0, -.9, .66), SIDE(-.9, .66, -.38, 0), kNone,
  SIDE(1, 0, 1, 1), kNone, kNone,
  SIDE(1.1, 0, .3, .3), kNone, kNone,
  kNone, kNone, kNone,
  SIDE(1, 0, 1, .18), SIDE(1, .18, 0, .18), kNone,
  SIDE(1, 0, .5, .5), kNone, kNone,
  SIDE(-.05, 0, 1, .34), SIDE(1, .34, -.7, 1), SIDE(-.7, 1, -.38, 0));
const float kFold[kShapes] = float[](0, 2, 1, 0, 2, 2, 0, 1, 2, 0);
// Radius of the circle through the furthest corners: the shape ends there too. It is what a ring is made of, and
// it bevels the light past sharp corners, which would else shoot out as long needles.
const float kRadius[kShapes] = float[](1.11, 1.415, 1, 1.117, 1.415, 1.1, 1, 1.02, 1, 1.221);
// Extent: smallest x, largest x, largest |y|; width of the line.
const vec4 kExtent[kShapes] = vec4[](
  vec4(-.62, 1, .92, 1), vec4(-1, 1, 1, 1), vec4(-1, 1, .866, 1.7), vec4(-.9, 1, .66, 1), vec4(-1, 1, 1, .8),
  vec4(-1.1, 1.1, 1.1, 1), vec4(-1, 1, 1, .85), vec4(-1, 1, .18, 1), vec4(-1, 1, 1, .8), vec4(-.7, 1, 1, 1.25));
// Fill when full of energy, fill when spent; how strongly the inside covers; whether the shape turns with its
// heading (an upright rectangle is what collides, so that is what is shown).
const vec4 kFill[kShapes] = vec4[](
  vec4(.26, .04, .75, 1), vec4(.22, .04, .75, 0), vec4(.34, .03, .85, 1), vec4(.40, .05, .6, 1), vec4(.75, .10, .75, 0),
  vec4(.36, .04, .75, 1), vec4(.24, .03, .75, 1), vec4(.9, .9, .5, 1), vec4(.55, .55, .3, 0), vec4(.16, .16, .85, 1));
const float kInnerRing[kShapes] = float[](0, 0, 0, 0, 0, 0, .5, 0, 0, 0);
// How much further than others' its glow reaches: the ship's, so that one finds oneself.
const float kReach[kShapes] = float[](1, 1, 1, 1, 1, 1, 1, .8, 1, 2.2);

const float kAnnounced_ticks = 30;  // World::announced_ticks as the rules start from it: when the outline arrives
const float kAnnouncedScale = 2;    // and how much larger than the shape it starts

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
  float reach_px = min(light.x * unit_px, light.y) * kReach[shape];
  side0 = kSides[shape * 3];
  side1 = kSides[shape * 3 + 1];
  side2 = kSides[shape * 3 + 2];
  kind = vec3(kFold[shape], shape == 4 ? 1 : 0, kInnerRing[shape]);
  scale = vec4(unit_px, clamp(.075 * unit_px, .55, 1.6) * lineWidth, max(reach_px, 1), kRadius[shape]);

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
