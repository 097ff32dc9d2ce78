/* SPDX-License-Identifier: Apache-2.0 */
/* A stand-in for the DHD library of Force Dimension, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one, as far as hapticut needs them, and none of its text. It drives nothing.
 */
#ifndef HAPTICUT_STAND_IN_DHDC_H
#define HAPTICUT_STAND_IN_DHDC_H

/* The manual wants the system named by a macro that no compiler predefines; without it nothing here may parse, so that
   the tests notice when nobody names it. */
#if defined(_WIN32)
#define __SDK __stdcall
#elif defined(LINUX) || defined(MACOSX)
#define __SDK
#else
#error "define LINUX, MACOSX or WIN64 (stand-in)"
#endif

/* At global scope, as in the real header: whoever includes it has these names. */
typedef unsigned char uchar;
typedef unsigned short ushort;
typedef unsigned int uint;
typedef unsigned long ulong;

#define DHD_DEVICE_NONE 0
#define DHD_DEVICE_OMEGA3 33
#define DHD_DEVICE_OMEGA6_RIGHT 34
#define DHD_DEVICE_OMEGA7_RIGHT 35
#define DHD_DEVICE_OMEGA6_LEFT 36
#define DHD_DEVICE_OMEGA7_LEFT 37
#define DHD_DEVICE_FALCON 60
#define DHD_DEVICE_DELTA3 63
#define DHD_DEVICE_CONTROLLER 81
#define DHD_DEVICE_CONTROLLER_HR 82
#define DHD_DEVICE_CUSTOM 91
#define DHD_DEVICE_SIGMA7_RIGHT 104
#define DHD_DEVICE_SIGMA7_LEFT 105
#define DHD_DEVICE_LAMBDA7_RIGHT 108
#define DHD_DEVICE_LAMBDA7_LEFT 109
#define DHD_DEVICE_LAMBDA6_RIGHT 131
#define DHD_DEVICE_LAMBDA6_LEFT 132
#define DHD_DEVICE_LAMBDA3 203
#define DHD_DEVICE_SIGMA3 206

#define DHD_ON 1
#define DHD_OFF 0
#define DHD_MAX_DOF 8

/* Not errors. */
#define DHD_TIMEGUARD 1
#define DHD_MOTOR_SATURATED 2

enum {
  DHD_NO_ERROR,
  DHD_ERROR,
  DHD_ERROR_COM,
  DHD_ERROR_DHC_BUSY,
  DHD_ERROR_NO_DRIVER_FOUND,
  DHD_ERROR_NO_DEVICE_FOUND,
  DHD_ERROR_NOT_AVAILABLE,
  DHD_ERROR_TIMEOUT,
  DHD_ERROR_GEOMETRY,
  DHD_ERROR_EXPERT_MODE_DISABLED,
  DHD_ERROR_NOT_IMPLEMENTED,
  DHD_ERROR_OUT_OF_MEMORY,
  DHD_ERROR_DEVICE_NOT_READY,
  DHD_ERROR_FILE_NOT_FOUND,
  DHD_ERROR_CONFIGURATION,
  DHD_ERROR_INVALID_INDEX,
  DHD_ERROR_DEPRECATED,
  DHD_ERROR_NULL_ARGUMENT,
  DHD_ERROR_REDUNDANT_FAIL,
  DHD_ERROR_NOT_ENABLED,
  DHD_ERROR_DEVICE_IN_USE,
  DHD_ERROR_INVALID,
  DHD_ERROR_NO_REGULATION
};

#define DHD_MAX_STATUS 17
#define DHD_STATUS_POWER 0
#define DHD_STATUS_CONNECTED 1
#define DHD_STATUS_STARTED 2
#define DHD_STATUS_RESET 3
#define DHD_STATUS_IDLE 4
#define DHD_STATUS_FORCE 5
#define DHD_STATUS_BRAKE 6
#define DHD_STATUS_TORQUE 7
#define DHD_STATUS_WRIST_DETECTED 8
#define DHD_STATUS_ERROR 9
#define DHD_STATUS_GRAVITY 10
#define DHD_STATUS_TIMEGUARD 11
#define DHD_STATUS_WRIST_INIT 12
#define DHD_STATUS_REDUNDANCY 13
#define DHD_STATUS_FORCE_OFF_CAUSE 14
#define DHD_STATUS_LOCKS 15
#define DHD_STATUS_AXIS_CHECKED 16

#define DHD_FORCE_OFF_NONE 0
#define DHD_FORCE_OFF_BUTTON 1
#define DHD_FORCE_OFF_VELOCITY 2
#define DHD_FORCE_OFF_WATCHDOG 3
#define DHD_FORCE_OFF_SOFTWARE 4
#define DHD_FORCE_OFF_USBDISCN 5
#define DHD_FORCE_OFF_DEADMAN 6

/* Default arguments and bool: C++ only, like the real header in practice. */
extern "C" {
int __SDK dhdGetDeviceCount();
int __SDK dhdGetAvailableCount();
int __SDK dhdOpen();
int __SDK dhdOpenID(char ID);
int __SDK dhdOpenType(int type);
int __SDK dhdOpenSerial(int serial);
int __SDK dhdClose(char ID = -1);
int __SDK dhdStop(char ID = -1);
int __SDK dhdGetSystemType(char ID = -1);
const char* __SDK dhdGetSystemName(char ID = -1);
int __SDK dhdGetSerialNumber(ushort* sn, char ID = -1);
void __SDK dhdGetSDKVersion(int* major, int* minor, int* release, int* revision);
int __SDK dhdEnableForce(uchar val, char ID = -1);
int __SDK dhdGetStatus(int status[DHD_MAX_STATUS], char ID = -1);
bool __SDK dhdHasWrist(char ID = -1);
bool __SDK dhdHasActiveWrist(char ID = -1);
bool __SDK dhdHasGripper(char ID = -1);
bool __SDK dhdHasActiveGripper(char ID = -1);
bool __SDK dhdIsLeftHanded(char ID = -1);
int __SDK dhdGetPosition(double* px, double* py, double* pz, char ID = -1);
int __SDK dhdGetPositionAndOrientationFrame(double* px, double* py, double* pz, double matrix[3][3], char ID = -1);
int __SDK dhdGetOrientationFrame(double matrix[3][3], char ID = -1);
int __SDK dhdGetLinearVelocity(double* vx, double* vy, double* vz, char ID = -1);
int __SDK dhdGetAngularVelocityRad(double* wx, double* wy, double* wz, char ID = -1);
int __SDK dhdConfigLinearVelocity(int ms = 20, int mode = 0, char ID = -1);
int __SDK dhdSetForce(double fx, double fy, double fz, char ID = -1);
int __SDK dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty, double tz, char ID = -1);
int __SDK dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz,
                                              double fg, char ID = -1);
int __SDK dhdGetForceAndTorqueAndGripperForce(double* fx, double* fy, double* fz, double* tx, double* ty, double* tz,
                                              double* fg, char ID = -1);
uint __SDK dhdGetButtonMask(char ID = -1);
int __SDK dhdGetButton(int index, char ID = -1);
double __SDK dhdGetComFreq(char ID = -1);
int __SDK dhdSetGravityCompensation(int val = DHD_ON, char ID = -1);
int __SDK dhdSetEffectorMass(double mass, char ID = -1);
int __SDK dhdSetBrakes(int val = DHD_ON, char ID = -1);
int __SDK dhdSetMaxForce(double f, char ID = -1);
int __SDK dhdSetMaxTorque(double t, char ID = -1);
double __SDK dhdGetMaxForce(char ID = -1);
double __SDK dhdGetMaxTorque(char ID = -1);
int __SDK dhdErrorGetLast();
const char* __SDK dhdErrorGetLastStr();
double __SDK dhdGetTime();
void __SDK dhdSleep(double sec);
void __SDK dhdEnableSimulator(bool on);

int __SDK dhdEnableExpertMode();
int __SDK dhdDisableExpertMode();
int __SDK dhdSetTimeGuard(int us, char ID = -1);
int __SDK dhdSetVelocityThreshold(uint val, char ID = -1);
int __SDK dhdSetWatchdog(unsigned char val, char ID = -1);
}

#endif
