#!/usr/bin/env bash
# OpenAL Soft, loopback device: the same sound comes 1 ms later when it is rendered as 16 bit integers than when it is
# rendered as floats, and rendering until the source has stopped loses the last 1 ms of it. The same in 1.24.2 and 1.25.2.
#
# One would guess that ALC_FORMAT_TYPE_SOFT chooses the type of the numbers and no more. But for 8, 16 and 32 bit integers
# the output limiter is on unless told otherwise, for floats it is off, and the limiter looks 1 ms ahead: 48 frames at
# 48000 Hz, 44 at 44100 Hz. AL_SOURCE_STATE does not count that delay. A sample position taken with floats is off with
# integers, and a sound whose rendering stops with its source ends in a click. The attribute ALC_OUTPUT_LIMITER_SOFT with
# ALC_FALSE helps.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=1:1.19.1-2
for package in libopenal-dev libopenal1; do
  [[ "$(dpkg-query -W -f '${Version}' "$package" 2>/dev/null)" == "$version" ]] || {
    echo "$package $version is not installed." >&2
    exit 2
  }
done
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2

cat >render.cpp <<'CPP'
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>
template <class Sample>
static bool render(const char* what, ALCint type, ALCint rate, std::vector<ALCint> more = {}) {
  const float scale = type == ALC_FLOAT_SOFT ? 1.0f : 1.0f / 32768;
  const auto open = (LPALCLOOPBACKOPENDEVICESOFT)alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT");
  const auto samples = (LPALCRENDERSAMPLESSOFT)alcGetProcAddress(nullptr, "alcRenderSamplesSOFT");
  std::vector<ALCint> attributes{ALC_FORMAT_TYPE_SOFT, type, ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT,
                                 ALC_FREQUENCY,        rate};
  attributes.insert(attributes.end(), more.begin(), more.end());
  attributes.push_back(0);
  ALCdevice* device = open(nullptr);
  ALCcontext* context = alcCreateContext(device, attributes.data());
  if (!alcMakeContextCurrent(context)) return false;
  const std::vector<std::int16_t> sound(2 * 1000, 8000);  // 1000 frames, a quarter of full scale
  ALuint buffer, source;
  alGenBuffers(1, &buffer);
  alGenSources(1, &source);
  alBufferData(buffer, AL_FORMAT_STEREO16, sound.data(), ALsizei(2 * sound.size()), rate);
  alSourcei(source, AL_BUFFER, ALint(buffer));
  alSourcePlay(source);
  int frames = 0, heard = 0, first = -1;
  for (ALint state = AL_PLAYING; state == AL_PLAYING; alGetSourcei(source, AL_SOURCE_STATE, &state)) {
    Sample out[2 * 10] = {};
    samples(device, out, 10);
    for (int i = 0; i < 10; ++i, ++frames) {
      if (std::fabs(out[2 * i] * scale) < 0.1f) continue;  // integers are dithered: silence is not all 0
      if (first < 0) first = frames;
      ++heard;
    }
  }
  std::printf("%s, %d Hz: %d frames until the source has stopped, sound from frame %d on, %d frames of it\n", what, rate,
              frames, first, heard);
  alcMakeContextCurrent(nullptr);
  alcDestroyContext(context);
  alcCloseDevice(device);
  return true;
}
int main() {
  const bool done = render<float>("float", ALC_FLOAT_SOFT, 48000) && render<std::int16_t>("short", ALC_SHORT_SOFT, 48000) &&
                    render<std::int16_t>("short", ALC_SHORT_SOFT, 44100) &&
                    render<std::int16_t>("short without limiter", ALC_SHORT_SOFT, 48000,
                                         {ALC_OUTPUT_LIMITER_SOFT, ALC_FALSE});
  return done ? 0 : 2;
}
CPP
g++ -std=c++17 render.cpp -lopenal -o render || exit 2
seen="$(HOME="$folder" XDG_CONFIG_HOME="$folder" XDG_CONFIG_DIRS="$folder" ALSOFT_CONF='' ./render)" || exit 2
expected='float, 48000 Hz: 1000 frames until the source has stopped, sound from frame 0 on, 1000 frames of it
short, 48000 Hz: 1000 frames until the source has stopped, sound from frame 48 on, 952 frames of it
short, 44100 Hz: 1000 frames until the source has stopped, sound from frame 44 on, 956 frames of it
short without limiter, 48000 Hz: 1000 frames until the source has stopped, sound from frame 0 on, 1000 frames of it'
echo "OpenAL Soft $version, a sound of 1000 frames:"
echo "$seen"
[[ "$seen" == "$expected" ]]
