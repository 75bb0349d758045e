#include "game/audio/openal_mixer.h"

#include <AL/alext.h>

#include <optional>
#include <stdexcept>
#include <string_view>

#include "render/quiet_stderr.h"

namespace gw {

namespace {

// Where a side is, on the unit circle in front of the listener.
void place(ALuint source, Side side) {
  constexpr float kAside = 0.4f, kAhead = 0.916515f;
  const float x = side == Side::left ? -kAside : side == Side::right ? kAside : 0.0f;
  alSource3f(source, AL_POSITION, x, 0, x == 0 ? -1.0f : -kAhead);
}

// The number of the resampler that never goes beyond the samples it lies between; none where OpenAL gives no choice.
// The default was that one up to 1.22; the splines since then overshoot a step by some 7 %, which no head room is for.
std::optional<ALint> linearResampler() {
  if (!alIsExtensionPresent("AL_SOFT_source_resampler")) return std::nullopt;
  const auto nameOf = reinterpret_cast<LPALGETSTRINGISOFT>(alGetProcAddress("alGetStringiSOFT"));
  if (nameOf == nullptr) return std::nullopt;
  for (ALint i = 0; i < alGetInteger(AL_NUM_RESAMPLERS_SOFT); ++i) {
    const ALchar* name = nameOf(AL_RESAMPLER_NAME_SOFT, i);
    if (name != nullptr && std::string_view(name) == "Linear") return i;
  }
  return std::nullopt;
}

}  // namespace

OpenalMixer::OpenalMixer(ALCdevice* device, const ALCint* attributes, const SoundBank& bank) : device_(device) {
  context_ = alcCreateContext(device_, attributes);
  if (!context_ || !alcMakeContextCurrent(context_)) {
    close();
    throw std::runtime_error("the sound device gives no context");
  }
  reportsLoss_ = alcIsExtensionPresent(device_, "ALC_EXT_disconnect") == ALC_TRUE;
  alGetError();
  alGenSources(ALsizei(sources_.size()), sources_.data());
  alGenSources(1, &musicSource_);
  for (uint32_t s = 0; s < kSounds; ++s) buffers_[s] = upload(bank.effects[s]);
  musicBuffer_ = upload(bank.music);
  if (alGetError() != AL_NO_ERROR) {
    close();
    throw std::runtime_error("the sound device has too few voices");
  }
  const std::optional<ALint> resampler = linearResampler();
  const auto prepare = [&](ALuint source) {
    alSourcei(source, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(source, AL_ROLLOFF_FACTOR, 0);
    if (resampler) alSourcei(source, AL_SOURCE_RESAMPLER_SOFT, *resampler);
  };
  for (const ALuint source : sources_) prepare(source);
  prepare(musicSource_);
  place(musicSource_, Side::middle);
  if (musicBuffer_ != 0) {
    alSourcei(musicSource_, AL_BUFFER, ALint(musicBuffer_));
    alSourcei(musicSource_, AL_LOOPING, AL_TRUE);
    alSourcef(musicSource_, AL_GAIN, 0);
    alSourcePlay(musicSource_);
  }
}

OpenalMixer::~OpenalMixer() {
  close();
}

void OpenalMixer::close() {
  if (context_) {
    alDeleteSources(ALsizei(sources_.size()), sources_.data());
    alDeleteSources(1, &musicSource_);
    for (const ALuint buffer : buffers_) alDeleteBuffers(1, &buffer);
    alDeleteBuffers(1, &musicBuffer_);
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context_);
  }
  alcCloseDevice(device_);
}

ALuint OpenalMixer::upload(const Clip& clip) {
  if (clip.samples.empty()) return 0;
  ALuint buffer = 0;
  alGenBuffers(1, &buffer);
  alBufferData(buffer, AL_FORMAT_MONO16, clip.samples.data(), ALsizei(clip.samples.size() * 2), ALsizei(clip.rate_hz));
  return buffer;
}

bool OpenalMixer::start(const VoiceStart& start) {
  const ALuint buffer = buffers_[uint32_t(start.sound)], source = sources_[start.voice];
  alSourceStop(source);
  if (buffer == 0) return false;
  startGain_[start.voice] = start.gain;
  place(source, start.side);
  alSourcei(source, AL_BUFFER, ALint(buffer));
  alSourcef(source, AL_GAIN, start.gain * effects_);
  alSourcef(source, AL_PITCH, start.pitch);
  alSourcePlay(source);
  return true;
}

std::optional<float> OpenalMixer::position_s(uint32_t voice) const {
  ALint state = AL_STOPPED;
  alGetSourcei(sources_[voice], AL_SOURCE_STATE, &state);
  if (state != AL_PLAYING) return std::nullopt;
  ALfloat position_s = 0;
  alGetSourcef(sources_[voice], AL_SEC_OFFSET, &position_s);
  return position_s;
}

void OpenalMixer::setEffects(float gain) {
  if (gain == effects_) return;
  effects_ = gain;
  for (uint32_t v = 0; v < Voices::kVoices; ++v) alSourcef(sources_[v], AL_GAIN, startGain_[v] * effects_);
}

void OpenalMixer::setMusic(float gain, float pitch) {
  alSourcef(musicSource_, AL_GAIN, gain);
  alSourcef(musicSource_, AL_PITCH, pitch);
}

bool OpenalMixer::connected() const {
  ALCint connected = ALC_TRUE;
  if (reportsLoss_) alcGetIntegerv(device_, ALC_CONNECTED, 1, &connected);
  return connected != ALC_FALSE;
}

std::unique_ptr<Mixer> openMixer(const SoundBank& bank) {
  // Without a card the libraries underneath write a dozen lines; the game says it in one.
  const QuietStderr quiet;
  ALCdevice* device = alcOpenDevice(nullptr);
  if (!device) return nullptr;
  try {
    return std::make_unique<OpenalMixer>(device, nullptr, bank);
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

}  // namespace gw
