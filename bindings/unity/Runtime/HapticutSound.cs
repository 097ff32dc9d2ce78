// SPDX-License-Identifier: Apache-2.0
using UnityEngine;

namespace Hapticut {

  /// <summary>The sound of a scene's drill, rendered in the audio thread. Add it to the object of a playing
  /// AudioSource.</summary>
  [RequireComponent(typeof(AudioSource))]
  public sealed class HapticutSound : MonoBehaviour {
    public HapticutScene scene;
    [Range(0.01f, 1)] public float volume = 0.5f;

    Sound sound_;
    double rate_;
    float[] channel_ = new float[0];

    void OnEnable() {
      rate_ = AudioSettings.outputSampleRate;
      sound_ = Sound.Open(0, volume);
    }

    void OnDisable() {
      Sound ended = sound_;
      sound_ = null;
      if (ended != null) ended.Dispose();
    }

    void OnAudioFilterRead(float[] data, int channels) {
      Sound sound = sound_;
      HapticutScene.SoundSource heard = scene != null ? scene.heard : null;
      if (sound == null || heard == null || channels < 1) return;
      if (channel_.Length != data.Length / channels) channel_ = new float[data.Length / channels];
      try {
        sound.Render(heard.input, rate_, channel_);
      } catch (System.ObjectDisposedException) {
        return;  // the component was switched off during this call
      }
      for (int n = 0; n < data.Length; ++n) data[n] += channel_[n / channels];
    }
  }
}
