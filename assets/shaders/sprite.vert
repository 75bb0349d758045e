#version 450 core
// One instance = one SpriteVertex (render/sprite_vertex.h); its quad hugs the shape and the glow round it.

layout(location = 0) in vec4 places;     // x, y at the end of the tick; x, y one tick earlier
layout(location = 1) in vec2 angleSize;  // heading in radians, half extent in metres
layout(location = 2) in uvec2 look;      // shape, flags, energy, age; colour 0xRRGGBB

layout(location = 0) uniform vec4 camera;     // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 view;       // share of the tick passed; ticks so far; pixels per metre; brightness
layout(location = 2) uniform vec4 light;      // glow: reach as a share of the shape, most pixels, strength; flashes wanted
layout(location = 3) uniform float announced_ticks;  // the age at which an announced outline has closed in

out vec2 at;                        // place in the shape's own units: its half extent is 1, +x its heading
flat out vec3 side0, side1, side2;  // sides of the folded shape: outward normal, distance from the middle
flat out vec3 kind;                 // fold; chequers; radius of an inner ring, or 0
flat out vec4 scale;                // pixels per unit; half line width and glow reach in pixels; radius of the whole
flat out vec4 tint;                 // colour; how strongly the inside covers what lies below
flat out vec3 lit;                  // brightness of fill, of line, of glow

// The shapes: SHAPES and the lists SHAPE_... come from render/sprite_shapes.h, which says what they mean.
// From one corner to the next, counter-clockwise, so that the inside is to the left.
#define NORMAL(ax, ay, bx, by) normalize(vec2((by) - (ay), (ax) - (bx)))
#define SIDE(ax, ay, bx, by) vec3(NORMAL(ax, ay, bx, by), dot(NORMAL(ax, ay, bx, by), vec2(ax, ay)))
#define NO_SIDE vec3(0, 0, 9)  // so far away that everything is inside
const vec3 kSides[SHAPES * 3] = vec3[](SHAPE_SIDES);
const float kFold[SHAPES] = float[](SHAPE_FOLDS);
const float kRadius[SHAPES] = float[](SHAPE_RADII);
const vec4 kExtent[SHAPES] = vec4[](SHAPE_EXTENTS);  // smallest x, largest x, largest |y|; width of the line
const vec4 kFill[SHAPES] = vec4[](SHAPE_FILLS);      // full of energy, spent; cover; whether it turns
const float kChequers[SHAPES] = float[](SHAPE_CHEQUERS);
const float kInnerRing[SHAPES] = float[](SHAPE_INNER_RINGS);
const float kReach[SHAPES] = float[](SHAPE_GLOW_REACHES);

void main() {
  int shape = min(int(look.x & 255u), SHAPES - 1);
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
    float done = clamp((age_ticks - 1 + view.x) / announced_ticks, 0.0, 1.0);
    size_m *= 1 + ANNOUNCED_SCALE * (1 - done) * (1 - done);
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
  kind = vec3(kFold[shape], kChequers[shape], kInnerRing[shape]);
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
