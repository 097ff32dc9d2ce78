// SPDX-License-Identifier: Apache-2.0
// A program in C# whose runtime turns SIGSEGV into exceptions, while a loop of hapticut runs.
using System;
using System.Runtime.InteropServices;
using System.Threading;

static class LivesOn {
  [DllImport("loop_for_mono")] static extern int loop_start(int stop_on_crash);
  [DllImport("loop_for_mono")] static extern ulong loop_ticks();
  [DllImport("loop_for_mono")] static extern int loop_has_force();
  [DllImport("loop_for_mono")] static extern int loop_has_fault();
  [DllImport("loop_for_mono")] static extern void loop_reset_fault();
  [DllImport("loop_for_mono")] static extern void loop_stop();

  class Thing { public volatile int value = 1; }
  static Thing nothing = null;

  static void Require(bool condition, string what) {
    if (condition) return;
    Console.WriteLine("failed: " + what);
    Environment.Exit(1);
  }

  static void WaitFor(Func<bool> condition, string what) {
    for (int n = 0; n < 20000 && !condition(); ++n) Thread.Sleep(1);
    Require(condition(), what);
  }

  static int CaughtOf(int tries) {
    int caught = 0;
    for (int n = 0; n < tries; ++n)
      try {
        caught += nothing.value - nothing.value;
      } catch (NullReferenceException) {
        ++caught;
      }
    return caught;
  }

  static void GoesOnTicking() {
    ulong before = loop_ticks();
    WaitFor(() => loop_ticks() > before + 50, "the loop has stopped ticking");
  }

  static int Main() {
    // Without stop_on_crash the loop ignores the signal.
    Require(loop_start(0) == 1, "the loop does not start");
    WaitFor(() => loop_has_force() == 1, "there is no force");
    Require(CaughtOf(100) == 100, "an exception was lost");
    GoesOnTicking();
    Require(loop_has_fault() == 0, "the force was switched off without a request");
    loop_stop();

    // With stop_on_crash the force is switched off, the program survives, and after a reset the force comes back.
    Require(loop_start(1) == 1, "the loop does not start again");
    WaitFor(() => loop_has_force() == 1, "there is no force again");
    Require(CaughtOf(1) == 1, "the handler of hapticut lost an exception");
    GoesOnTicking();
    Require(loop_has_fault() == 1, "the force was not switched off");
    loop_reset_fault();
    WaitFor(() => loop_has_force() == 1, "the force did not come back after a reset");
    loop_stop();
    Require(CaughtOf(1) == 1, "the runtime lost its handler");
    Console.WriteLine("lives");
    return 0;
  }
}
