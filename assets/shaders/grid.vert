#version 450 core
// One instance = one line of the background, a strip cut into pieces: at least one per band of the screen, so that
// unrest can tear the bands apart, and short ones where lines bend. Instances in order: upright lines, level lines,
// the four walls (left, right, bottom, top).
//
//   sections of an upright line, two bands of two pieces:   0--1--2 3--4--5   (2 and 3 are one place in two bands)

layout(location = 0) uniform vec4 camera;  // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 world;   // width and height of the world in metres; pixels per metre
layout(location = 2) uniform ivec4 lines;  // first upright, upright count, first level, level count
layout(location = 3) uniform vec4 mood;    // time in seconds; unrest; brightness; time step of the flicker
layout(location = 4) uniform ivec3 cuts;   // pieces per band; bands of the screen; bends
layout(location = 8) uniform vec4 bends[32];  // two per bend: place, radius, width; strength (all in metres)

out float across_px;                    // from the middle of the line
out float along_m;
out float stir;                         // how far a bend has moved the line here, metres
flat out vec4 tint;                     // colour; half width in pixels, negative for a wall's glow
flat out vec4 data;                     // of what runs along the line: speed (m/s, signed), offset in metres, strength;
                                        // and the length of a wall in metres

const float kStep_m = 4;                // between lines
const int kMajor = 5;                   // every so many lines a brighter one
const float kWallGlow_m = 1.6;
const vec3 kMinorColour = vec3(.030, .062, .135);
const vec3 kMajorColour = vec3(.055, .125, .260);
const vec3 kWallColour = vec3(.25, .55, 1.0);
const vec3 kUneasyColour = vec3(1.0, .22, .16);
const float kTear_m = 1.4;              // furthest a torn band moves

// Repeatable noise for looks only. Integer mixing, since sin-based hashes differ between drivers.
float noise(int a, int b) {
  uint x = uint(a) * 0x9E3779B9u ^ uint(b) * 0x85EBCA6Bu;
  x ^= x >> 16; x *= 0x7FEB352Du; x ^= x >> 15; x *= 0x846CA68Bu; x ^= x >> 16;
  return float(x >> 8) / 16777216.0;
}

// How far the bends move a place: outwards from each bend's middle, most at its radius, smoothly to nothing at its
// width to either side and at the middle itself.
vec2 bent(vec2 place) {
  vec2 moved = vec2(0);
  for (int i = 0; i < cuts.z; ++i) {
    vec4 bend = bends[2 * i];
    vec2 from = place - bend.xy;
    float away = length(from), off = min(abs(away - bend.z) / bend.w, 1.0);
    float profile = (1 - off * off) * (1 - off * off);
    moved += from * (bends[2 * i + 1].x * profile / max(away, bend.w * .5));
  }
  return moved;
}

void main() {
  int id = gl_InstanceID;
  bool wall = id >= lines.y + lines.w;
  int side = id - lines.y - lines.w;
  bool upright = wall ? side < 2 : id < lines.y;
  int index = upright ? lines.x + id : lines.z + id - lines.y;
  bool major = !wall && index % kMajor == 0;

  float pixelsPerMetre = world.z;
  float unrest = mood.y;
  float half_px = wall ? kWallGlow_m * pixelsPerMetre : .5;
  float pad_m = wall ? kWallGlow_m : 1.5 / pixelsPerMetre;
  float middle = wall ? float(side & 1) * (upright ? world.x : world.y) : float(index) * kStep_m;

  vec2 inView = 1 / camera.zw;
  float past_m = wall ? kWallGlow_m : 0;  // walls shine round their corners
  vec2 low = max(vec2(-past_m), camera.xy - inView - kTear_m);
  vec2 high = min(world.xy + past_m, camera.xy + inView + kTear_m);
  int section = gl_VertexID >> 1;
  int slice = section / (cuts.x + 1);
  float share = float(section - slice) / float(cuts.x * cuts.y);
  float height = upright ? share : (middle - camera.y + inView.y) / (2 * inView.y);  // 0..1 up the screen
  int band = upright ? slice : int(floor(height * float(cuts.y)));
  along_m = upright ? clamp(camera.y + (2 * height - 1) * inView.y, low.y, high.y) : mix(low.x, high.x, share);
  float beside_m = ((gl_VertexID & 1) * 2 - 1) * pad_m;
  across_px = beside_m * pixelsPerMetre;
  vec2 place = upright ? vec2(middle + beside_m, along_m) : vec2(along_m, middle + beside_m);

  stir = 0;
  if (!wall && cuts.z > 0) {
    vec2 moved = bent(upright ? vec2(middle, along_m) : vec2(along_m, middle));
    place += moved;
    stir = length(moved);
  }

  // Tearing: now and then a band of the picture slips sideways.
  int beat = int(mood.w);
  float slip = noise(band, beat);
  if (slip < unrest * unrest * .35) place.x += (noise(band, beat + 7919) * 2 - 1) * kTear_m * unrest;

  float flicker = 1 - unrest * .65 * noise(id * 31 + 5, beat);
  vec3 colour = wall ? kWallColour : major ? kMajorColour : kMinorColour;
  colour = mix(colour, kUneasyColour * dot(colour, vec3(.5, .6, .5)), unrest * .7);
  tint = vec4(colour * flicker * mood.z, wall ? -half_px : half_px);

  float speed = (6 + 10 * noise(index, 1)) * (noise(index, 2) < .5 ? -1 : 1);
  data = vec4(speed, 200 * noise(index, upright ? 3 : 4), major ? 1 : 0, upright ? world.y : world.x);
  gl_Position = vec4((place - camera.xy) * camera.zw, 0, 1);
}
