// SPDX-License-Identifier: Apache-2.0
using UnityEditor;

namespace Hapticut {

  /// <summary>Ends all loops before the editor reloads assemblies: a device must not run without its scene.</summary>
  [InitializeOnLoad]
  static class StopBeforeReload {
    static StopBeforeReload() { AssemblyReloadEvents.beforeAssemblyReload += HapticutScene.StopAll; }
  }
}
