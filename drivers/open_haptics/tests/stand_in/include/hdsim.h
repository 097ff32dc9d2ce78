/* SPDX-License-Identifier: Apache-2.0 */
/* Control of the stand-in for the OpenHaptics device library, for tests: functions to change and to observe it. */
#ifndef HAPTICUT_HDSIM_H
#define HAPTICUT_HDSIM_H

#ifdef __cplusplus
extern "C" {
#endif

/* The properties of a simulated device; hdsim_touch and hdsim_premium6dof fill in those of two real ones. */
typedef struct {
  const char* name; /* for hdInitDevice; NULL selects the first device */
  const char* model;
  int input_dof, output_dof;
  double stiffness;                                         /* N/mm */
  double force, continuous;                                 /* N */
  double torque_force, torque_continuous, torque_stiffness; /* mNm, mNm, mNm/rad */
  double workspace[6];                                      /* mm */
  int calibration_style;
} hdsim_device;

/* Removes all devices, stops the scheduler, and selects the manual clock. */
void hdsim_reset(void);

hdsim_device hdsim_touch(const char* name);
hdsim_device hdsim_premium6dof(const char* name);

/* Adds a device. Returns its index. */
int hdsim_add_device(const hdsim_device* device);

/* Makes hdInitDevice refuse this name (NULL: the default device) with HD_DEVICE_FAULT. */
void hdsim_refuse_name(const char* name);

/* 1: hdInitDevice needs hdDeploymentLicense first. */
void hdsim_require_license(int required);

/* Column-major, mm. The rotation is not normalized. */
void hdsim_set_transform(int device, const double transform[16]);
void hdsim_set_velocity(int device, const double velocity[3]);
void hdsim_set_buttons(int device, int buttons);
void hdsim_set_temperature(int device, double hottest);
void hdsim_set_calibration(int device, unsigned int status);
/* hdUpdateCalibration moves the reported position by this much, in mm. */
void hdsim_set_calibration_jump(int device, const double jump[3]);
void hdsim_set_nan(int device, int nan);
/* The device stops answering: HD_COMM_ERROR, internal code -28, on every frame. */
void hdsim_unplug(int device, int unplugged);

/* Pushes an error. */
void hdsim_inject_error(int device, unsigned int code, int internal);
/* hdStartScheduler fails with HD_TIMER_ERROR. */
void hdsim_fail_start(int fail);

/* 1: hdStartScheduler starts a thread with the rate of the scheduler; 0 (default): the test runs the ticks. */
void hdsim_use_thread(int use);
/* Runs ticks of the manual clock in the calling thread. Returns how many callbacks it called. */
int hdsim_run_ticks(int ticks);
/* Calls the callback that hdUnschedule removed last, like a late driver. Returns its result. */
unsigned int hdsim_call_late(void);
/* [s] Time of the ticks since hdsim_reset. */
double hdsim_time(void);
int hdsim_is_running(void);
int hdsim_scheduled_callbacks(void);

/* The committed force and torque. N and mNm. */
void hdsim_get_committed_force(int device, double force[3], double torque[3]);
/* The force that the motors rendered in the last tick. It is the committed force, limited by a ramp at
   HD_FORCE_RAMPING_RATE after the start and after a limit was exceeded (speed, step of the force, force without
   clamping). */
void hdsim_get_rendered_force(int device, double force[3]);
/* The n-th committed force of the run, n < hdsim_committed_count. */
long hdsim_committed_count(int device);
void hdsim_get_committed(int device, long n, double force[3], double torque[3]);

/* Counters and flags of correct and incorrect use. */
typedef struct {
  long frames;              /* completed */
  long open_frames;         /* begun and not ended at the end of a tick */
  long ticks_without_frame; /* while the device's owner had a callback */
  long illegal_begins, illegal_ends;
  long sets_outside_frame, gets_outside_frame;
  long torque_sets_on_3dof;
  long amplifier_toggles; /* a limit was exceeded: the force was zero, and returned on a ramp */
  int force_output_enabled;
  int callbacks_at_disable;   /* still scheduled when hdDisableDevice was called; -1: never called */
  int running_at_init;        /* hdInitDevice was called while the scheduler ran */
  int zero_force_before_stop; /* 1: the last committed force was zero when the scheduler stopped; -1: never stopped */
  int zero_force_before_disable; /* 1: the last committed force was zero at hdDisableDevice; -1: never disabled */
  int calibration_updates;
  int force_during_calibration;  /* 1: hdUpdateCalibration was called while a force was committed */
  const char* init_locale_point; /* how "1.5" was printed with %.1f during hdInitDevice */
} hdsim_counters;
hdsim_counters hdsim_get_counters(int device);

#ifdef __cplusplus
}
#endif

#endif
