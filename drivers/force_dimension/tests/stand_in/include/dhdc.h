/* SPDX-License-Identifier: Apache-2.0 */
/* A stand-in for the DHD library of Force Dimension, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one, as far as hapticut needs them, and none of its text. It drives nothing.
 */
#ifndef HAPTICUT_STAND_IN_DHDC_H
#define HAPTICUT_STAND_IN_DHDC_H

/* The manual requires a macro for the system, which no compiler predefines. Without it this header must not parse, so
   that the tests notice a missing macro. */
#if defined(_WIN32)
#define __SDK __stdcall
#elif defined(LINUX) || defined(MACOSX)
#define __SDK
#else
#error "define LINUX, MACOSX or WIN64 (stand-in)"
#endif

/* At global scope, as in the real header. */
typedef unsigned char uchar;
typedef unsigned short ushort;
typedef unsigned int uint;
typedef unsigned long ulong;

#define DHD_DEVICE_OMEGA3 33
#define DHD_DEVICE_OMEGA6_RIGHT 34
#define DHD_DEVICE_OMEGA7_RIGHT 35
#define DHD_DEVICE_FALCON 60
#define DHD_DEVICE_SIGMA7_RIGHT 104
#define DHD_DEVICE_SIGMA7_LEFT 105

#define DHD_ON 1
#define DHD_OFF 0

/* Not an error. */
#define DHD_MOTOR_SATURATED 2

enum {
  DHD_NO_ERROR = 0,
  DHD_ERROR_COM = 2,
  DHD_ERROR_NO_DEVICE_FOUND = 5,
  DHD_ERROR_NOT_AVAILABLE = 6,
  DHD_ERROR_EXPERT_MODE_DISABLED = 9,
  DHD_ERROR_DEVICE_NOT_READY = 12,
  DHD_ERROR_INVALID_INDEX = 15,
  DHD_ERROR_NOT_ENABLED = 19,
  DHD_ERROR_DEVICE_IN_USE = 20,
  DHD_ERROR_NO_REGULATION = 22,
};

#define DHD_MAX_STATUS 17
#define DHD_STATUS_POWER 0
#define DHD_STATUS_CONNECTED 1
#define DHD_STATUS_STARTED 2
#define DHD_STATUS_RESET 3
#define DHD_STATUS_IDLE 4
#define DHD_STATUS_FORCE 5
#define DHD_STATUS_BRAKE 6
#define DHD_STATUS_WRIST_DETECTED 8
#define DHD_STATUS_GRAVITY 10
#define DHD_STATUS_WRIST_INIT 12
#define DHD_STATUS_FORCE_OFF_CAUSE 14

#define DHD_FORCE_OFF_NONE 0
#define DHD_FORCE_OFF_VELOCITY 2
#define DHD_FORCE_OFF_WATCHDOG 3
#define DHD_FORCE_OFF_SOFTWARE 4
#define DHD_FORCE_OFF_USBDISCN 5

/* Default arguments and bool: C++ only, like the real header in practice. */
extern "C" {
int __SDK dhdGetDeviceCount();
int __SDK dhdGetAvailableCount();
int __SDK dhdOpen();
int __SDK dhdOpenType(int type);
int __SDK dhdOpenSerial(int serial);
int __SDK dhdClose(char ID = -1);
int __SDK dhdGetSystemType(char ID = -1);
const char* __SDK dhdGetSystemName(char ID = -1);
int __SDK dhdGetSerialNumber(ushort* sn, char ID = -1);
void __SDK dhdGetSDKVersion(int* major, int* minor, int* release, int* revision);
int __SDK dhdEnableForce(uchar val, char ID = -1);
int __SDK dhdGetStatus(int status[DHD_MAX_STATUS], char ID = -1);
bool __SDK dhdHasWrist(char ID = -1);
bool __SDK dhdHasActiveWrist(char ID = -1);
bool __SDK dhdIsLeftHanded(char ID = -1);
int __SDK dhdGetPosition(double* px, double* py, double* pz, char ID = -1);
int __SDK dhdGetPositionAndOrientationFrame(double* px, double* py, double* pz, double matrix[3][3], char ID = -1);
int __SDK dhdGetLinearVelocity(double* vx, double* vy, double* vz, char ID = -1);
int __SDK dhdGetAngularVelocityRad(double* wx, double* wy, double* wz, char ID = -1);
int __SDK dhdSetForce(double fx, double fy, double fz, char ID = -1);
int __SDK dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz,
                                              double fg, char ID = -1);
uint __SDK dhdGetButtonMask(char ID = -1);
int __SDK dhdSetGravityCompensation(int val = DHD_ON, char ID = -1);
int __SDK dhdSetEffectorMass(double mass, char ID = -1);
int __SDK dhdSetBrakes(int val = DHD_ON, char ID = -1);
int __SDK dhdSetMaxForce(double f, char ID = -1);
int __SDK dhdSetMaxTorque(double t, char ID = -1);
int __SDK dhdErrorGetLast();
const char* __SDK dhdErrorGetLastStr();

int __SDK dhdEnableExpertMode();
int __SDK dhdDisableExpertMode();
int __SDK dhdSetWatchdog(unsigned char val, char ID = -1);
}

#endif
