/* SPDX-License-Identifier: Apache-2.0 */
/* Control of the stand-in for the library of Force Dimension, for tests: functions to change and to observe it. Frame
   of the device: x towards the user, y to the right, z up. Metres, newtons, seconds. */
#ifndef HAPTICUT_DHDSIM_H
#define HAPTICUT_DHDSIM_H

#ifdef __cplusplus
extern "C" {
#endif

/* Why the forces are off: the numbers of the real library. */
enum dhdsim_cause {
  DHDSIM_OFF_NONE,
  DHDSIM_OFF_BUTTON,
  DHDSIM_OFF_VELOCITY,
  DHDSIM_OFF_WATCHDOG,
  DHDSIM_OFF_SOFTWARE,
  DHDSIM_OFF_USBDISCN,
  DHDSIM_OFF_DEADMAN
};

/* Calls that can be made to fail. */
enum dhdsim_call {
  DHDSIM_OPEN,
  DHDSIM_READ,
  DHDSIM_VELOCITY,
  DHDSIM_WRITE,
  DHDSIM_STATUS,
  DHDSIM_ENABLE,
  DHDSIM_CALLS
};

/* The properties of a simulated device. dhdsim_device_of fills in those of the real types that the tests use. */
typedef struct {
  int type, serial;
  const char* name;
  int wrist, active_wrist, left_handed;
  int has_watchdog;             /* 0: dhdSetWatchdog is not available */
  int has_brakes;               /* 0: dhdSetBrakes is not available */
  int reports_angular_velocity; /* 0: dhdGetAngularVelocityRad is not available */
} dhdsim_device;

/* Removes all devices, and stops the clock at 0. */
void dhdsim_reset(void);

dhdsim_device dhdsim_device_of(int type, int serial);

/* Adds a device. Returns its index, which is also its identifier. */
int dhdsim_add_device(const dhdsim_device* device);

/* Rows of the rotation of the stylus in the frame of the device. */
void dhdsim_set_pose(int device, const double position[3], const double rotation[9]);
void dhdsim_set_velocity(int device, const double linear[3], const double angular[3]);
void dhdsim_set_buttons(int device, unsigned int mask);
void dhdsim_set_nan(int device, int nan);
/* 0: the device waits for its calibration (mode RESET), and its forces cannot be switched on. */
void dhdsim_set_calibrated(int device, int calibrated);
/* 0: the encoders of the wrist have no zero. */
void dhdsim_set_wrist_initialised(int device, int initialised);
/* Every call fails with DHD_ERROR_COM from now on, and the motors have no force. */
void dhdsim_unplug(int device);
/* Another program has the device open. */
void dhdsim_set_in_use(int device, int in_use);
/* 1: opening a device that this process has open succeeds. */
void dhdsim_share(int device, int shared);

/* The next `times` calls of that kind fail with this error. */
void dhdsim_fail(int device, enum dhdsim_call call, int error, int times);
/* Successful readings and commands return this value: 1 time guard, 2 motors saturated. */
void dhdsim_return_on_success(int device, int value);

/* Switches the forces off as the device does for this cause. With BUTTON, DEADMAN and SOFTWARE they stay off until
   dhdsim_switch_on, and dhdEnableForce fails. */
void dhdsim_switch_off(int device, enum dhdsim_cause cause);
void dhdsim_switch_on(int device);

/* Advances the clock of watchdog and brakes, which otherwise stands still ... */
void dhdsim_advance(double seconds);
/* ... or lets it follow real time. */
void dhdsim_use_real_time(int use);
double dhdsim_time(void);

/* The commanded force that the amplifiers render; zero while the forces are off. */
void dhdsim_get_committed_force(int device, double force[3], double torque[3]);
/* The rendered force with gravity compensation. */
void dhdsim_get_motor_force(int device, double force[3]);
/* The rendered force of the n-th command, n < dhdsim_committed_count. */
long dhdsim_committed_count(int device);
void dhdsim_get_committed(int device, long n, double force[3], double torque[3]);

/* Counters and flags of correct and incorrect use. */
typedef struct {
  int force_on, brakes_on, gravity_on;
  int brakes_commanded;          /* by the last dhdSetBrakes */
  long commands;                 /* of forces */
  long torques_on_passive_wrist; /* commands with a torque that is not zero */
  long gripper_forces;           /* commands with a gripper force that is not zero */
  long enables, enables_in_vain; /* of the forces; in vain: against a button, a dead man's switch, another program */
  long expert_mode_violations;   /* expert calls outside expert mode */
  int expert_mode;               /* expert mode is on */
  int watchdog;                  /* multiples of 125 us */
  double max_force, max_torque, effector_mass;
  double unsupported; /* s with the forces on and without gravity compensation: the arm sinks */
  int auto_inits;
  int closes, calls_after_close;
  int zero_force_before_off; /* 1: the last command was zero when the program switched the forces off; -1: never */
  int off_before_close;      /* 1: forces off and brakes on when the device was closed; -1: never closed */
} dhdsim_counters;
dhdsim_counters dhdsim_get_counters(int device);

#ifdef __cplusplus
}
#endif

#endif
