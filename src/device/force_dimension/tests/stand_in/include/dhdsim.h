/* SPDX-License-Identifier: Apache-2.0 */
/* Control of the stand-in for the library of Force Dimension: what a test does to it, and what it saw. Frame of the
   device: x towards the user, y to the right, z up. Metres, newtons, seconds. */
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

/* What a simulated device is; dhdsim_device_of fills in what the types of real ones have that the tests ask for. */
typedef struct {
  int type, serial;
  const char* name;
  int wrist, active_wrist, left_handed;
  int has_watchdog;    /* 0: dhdSetWatchdog is not available */
  int has_brakes;      /* 0: dhdSetBrakes is not available */
  int reports_turning; /* 0: dhdGetAngularVelocityRad is not available */
} dhdsim_device;

/* Back to no devices and a clock that stands still at 0. */
void dhdsim_reset(void);

dhdsim_device dhdsim_device_of(int type, int serial);

/* Adds a device. Returns its index, which is its identifier too. */
int dhdsim_add_device(const dhdsim_device* device);

/* Rows of the rotation of the stylus in the frame of the device. */
void dhdsim_set_pose(int device, const double position[3], const double rotation[9]);
void dhdsim_set_velocity(int device, const double linear[3], const double angular[3]);
void dhdsim_set_buttons(int device, unsigned int mask);
void dhdsim_set_nan(int device, int nan);
/* 0: it waits for its calibration (mode RESET), and its forces cannot be switched on. */
void dhdsim_set_calibrated(int device, int calibrated);
/* 0: the encoders of the wrist have no zero. */
void dhdsim_set_wrist_initialised(int device, int initialised);
/* Every call fails with DHD_ERROR_COM from now on, and the motors get nothing. */
void dhdsim_unplug(int device);
/* Somebody else has it open. */
void dhdsim_set_in_use(int device, int in_use);
/* 1: a device that this process has open is opened again, instead of an error. */
void dhdsim_share(int device, int shared);

/* The next `times` calls of that kind fail with this error. */
void dhdsim_fail(int device, enum dhdsim_call call, int error, int times);
/* What readings and commands return instead of 0 when they succeed: 1 time guard, 2 motors saturated. */
void dhdsim_return_on_success(int device, int value);

/* Switches the forces off as the device would for that cause. With BUTTON, DEADMAN and SOFTWARE they stay off until
   dhdsim_switch_on, and dhdEnableForce fails. */
void dhdsim_switch_off(int device, enum dhdsim_cause cause);
void dhdsim_switch_on(int device);

/* The clock of watchdog and brakes: it stands still, but for this... */
void dhdsim_advance(double seconds);
/* ... or is the real one. */
void dhdsim_use_real_time(int use);
double dhdsim_time(void);

/* What the program has commanded and the amplifiers let through; zero while the forces are off. */
void dhdsim_get_committed_force(int device, double force[3], double torque[3]);
/* The same and what gravity compensation adds to it. */
void dhdsim_get_motor_force(int device, double force[3]);
/* The n-th command, n < dhdsim_committed_count, as it got through. */
long dhdsim_committed_count(int device);
void dhdsim_get_committed(int device, long n, double force[3], double torque[3]);

/* What was done right and wrong. */
typedef struct {
  int force_on, brakes_on, gravity_on;
  int brakes_commanded;          /* by the last dhdSetBrakes */
  long commands;                 /* of forces */
  long torques_on_passive_wrist; /* commands with a torque that is not zero */
  long gripper_forces;           /* commands with a gripper force that is not zero */
  long enables, enables_in_vain; /* of the forces; against a button, a dead man's switch, another program */
  long expert_mode_violations;   /* expert calls outside of expert mode */
  int expert_mode;               /* it is on now */
  int watchdog;                  /* multiples of 125 us */
  double max_force, max_torque, effector_mass;
  double unsupported; /* s with the forces on and nothing to carry the arm: it sinks */
  int auto_inits;
  int closes, calls_after_close;
  int zero_force_before_off; /* 1: the last command was zero when the program switched the forces off; -1: never */
  int off_before_close;      /* 1: forces off and brakes on when it was closed; -1: never closed */
} dhdsim_counters;
dhdsim_counters dhdsim_get_counters(int device);

#ifdef __cplusplus
}
#endif

#endif
