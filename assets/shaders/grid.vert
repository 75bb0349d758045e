#version 450 core
// One instance = one line of the background, a strip cut into segments so that unrest can tear it. Instances
// in order: upright lines, level lines, then the four walls (left, right, bottom, top).

layout(location = 0) uniform vec4 camera;  // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 world;   // half extents of the world in metres; pixels per metre; segments
layout(location = 2) uniform ivec4 lines;  // first upright, upright count, first level, level count
layout(location = 3) uniform vec4 mood;    // time in seconds; unrest; brightness; time step of the flicker

out float across_px;                    // from the middle of the line
out float along_m;
flat out vec4 tint;                     // colour; half width in pixels, negative for a wall's glow
flat out vec3 data;                     // of what runs along the line: speed (m/s, signed), offset in metres, strength

const float kStep_m = 4;                // between lines
const int kMajor = 5;                   // every so many lines a brighter one
const float kWallGlow_m = 1.6;
const vec3 kMinorColour = vec3(.022, .045, .095);
const vec3 kMajorColour = vec3(.045, .100, .200);
const vec3 kWallColour = vec3(.25, .55, 1.0);
const vec3 kUneasyColour = vec3(1.0, .22, .16);
const float kTear_m = 1.4;              // furthest a torn band moves
const float kBand_m = 1.5;              // height of a band that tears as one

// Repeatable noise for looks only. Integer mixing, since sin-based hashes differ between drivers.
float noise(int a, int b) {
  uint x = uint(a) * 0x9E3779B9u ^ uint(b) * 0x85EBCA6Bu;
  x ^= x >> 16; x *= 0x7FEB352Du; x ^= x >> 15; x *= 0x846CA68Bu; x ^= x >> 16;
  return float(x >> 8) / 16777216.0;
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
  float middle = wall ? ((side & 1) == 0 ? -1 : 1) * (upright ? world.x : world.y) : float(index) * kStep_m;

  // Only the part in view, so that segments are as short as tearing wants them.
  vec2 inView = 1 / camera.zw;
  vec2 low = max(-world.xy, camera.xy - inView - kTear_m) , high = min(world.xy, camera.xy + inView + kTear_m);
  float share = float(gl_VertexID >> 1) / world.w;
  along_m = upright ? mix(low.y, high.y, share) : mix(low.x, high.x, share);
  float beside_m = ((gl_VertexID & 1) * 2 - 1) * pad_m;
  across_px = beside_m * pixelsPerMetre;
  vec2 place = upright ? vec2(middle + beside_m, along_m) : vec2(along_m, middle + beside_m);

  // Tearing: now and then a band of the picture slips sideways.
  int beat = int(mood.w);
  int band = int(floor((upright ? along_m : middle) / kBand_m));
  float slip = noise(band, beat);
  if (slip < unrest * unrest * .35) place.x += (noise(band, beat + 7919) * 2 - 1) * kTear_m * unrest;

  float flicker = 1 - unrest * .65 * noise(id * 31 + 5, beat);
  vec3 colour = wall ? kWallColour : major ? kMajorColour : kMinorColour;
  colour = mix(colour, kUneasyColour * dot(colour, vec3(.5, .6, .5)), unrest * .7);
  tint = vec4(colour * flicker * mood.z, wall ? -half_px : half_px);

  float speed = (6 + 10 * noise(index, 1)) * (noise(index, 2) < .5 ? -1 : 1);
  data = major ? vec3(speed, 200 * noise(index, upright ? 3 : 4), 1) : vec3(0);
  gl_Position = vec4((place - camera.xy) * camera.zw, 0, 1);
}
