/* SPDX-License-Identifier: Apache-2.0 */
/* Part of a stand-in for the OpenHaptics device library, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one and none of its text. It drives nothing. */
#ifndef HAPTICUT_STAND_IN_HD_DEFINES_H
#define HAPTICUT_STAND_IN_HD_DEFINES_H

#include <HD/hdExport.h>
#include <stddef.h>

typedef unsigned int HDerror;
typedef unsigned int HDenum;
typedef unsigned int HHD;
typedef unsigned char HDboolean;
typedef unsigned long HDulong;
typedef unsigned short HDushort;
typedef int HDint;
typedef double HDdouble;
typedef const char* HDstring;

typedef struct {
  HDerror errorCode;
  int internalErrorCode;
  HHD hHD;
} HDErrorInfo;

#define HD_DEVICE_ERROR(X) ((X).errorCode != HD_SUCCESS)

/* Truth values and handles */
#define HD_TRUE 1
#define HD_FALSE 0
#define HD_INVALID_HANDLE 0xFFFFFFFF
#define HD_DEFAULT_DEVICE NULL

/* Version */
#define HD_VERSION_MAJOR_NUMBER 3
#define HD_VERSION_MINOR_NUMBER 00
#define HD_VERSION_BUILD_NUMBER 66

/* Errors */
#define HD_SUCCESS 0x0000
#define HD_INVALID_ENUM 0x0100
#define HD_INVALID_VALUE 0x0101
#define HD_INVALID_OPERATION 0x0102
#define HD_INVALID_INPUT_TYPE 0x0103
#define HD_BAD_HANDLE 0x0104
#define HD_WARM_MOTORS 0x0200
#define HD_EXCEEDED_MAX_FORCE 0x0201
#define HD_EXCEEDED_MAX_FORCE_IMPULSE 0x0202
#define HD_EXCEEDED_MAX_VELOCITY 0x0203
#define HD_FORCE_ERROR 0x0204
#define HD_DEVICE_FAULT 0x0300
#define HD_DEVICE_ALREADY_INITIATED 0x0301
#define HD_COMM_ERROR 0x0302
#define HD_COMM_CONFIG_ERROR 0x0303
#define HD_TIMER_ERROR 0x0304
#define HD_ILLEGAL_BEGIN 0x0400
#define HD_ILLEGAL_END 0x0401
#define HD_FRAME_ERROR 0x0402
#define HD_INVALID_PRIORITY 0x0500
#define HD_SCHEDULER_FULL 0x0501
#define HD_INVALID_LICENSE 0x0600

/* Readings */
#define HD_CURRENT_BUTTONS 0x2000
#define HD_CURRENT_VELOCITY 0x2051
#define HD_CURRENT_TRANSFORM 0x2052

/* Properties of the device */
#define HD_DEVICE_MODEL_TYPE 0x2501
#define HD_DEVICE_DRIVER_VERSION 0x2502
#define HD_DEVICE_VENDOR 0x2503
#define HD_DEVICE_SERIAL_NUMBER 0x2504
#define HD_MAX_WORKSPACE_DIMENSIONS 0x2550
#define HD_INPUT_DOF 0x2553
#define HD_OUTPUT_DOF 0x2554
#define HD_CALIBRATION_STYLE 0x2555

/* Rates and limits */
#define HD_UPDATE_RATE 0x2600
#define HD_NOMINAL_MAX_STIFFNESS 0x2602
#define HD_NOMINAL_MAX_FORCE 0x2603
#define HD_NOMINAL_MAX_CONTINUOUS_FORCE 0x2604
#define HD_MOTOR_TEMPERATURE 0x2605
#define HD_SOFTWARE_VELOCITY_LIMIT 0x2606
#define HD_SOFTWARE_FORCE_IMPULSE_LIMIT 0x2607
#define HD_FORCE_RAMPING_RATE 0x2608
#define HD_NOMINAL_MAX_DAMPING 0x2609
#define HD_NOMINAL_MAX_TORQUE_STIFFNESS 0x2620
#define HD_NOMINAL_MAX_TORQUE_FORCE 0x2622
#define HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE 0x2623

/* Forces */
#define HD_CURRENT_FORCE 0x2700
#define HD_CURRENT_TORQUE 0x2701

/* Switches */
#define HD_FORCE_OUTPUT 0x4000
#define HD_MAX_FORCE_CLAMPING 0x4001
#define HD_FORCE_RAMPING 0x4002
#define HD_SOFTWARE_FORCE_LIMIT 0x4003
#define HD_ONE_FRAME_LIMIT 0x4004

/* Calibration */
#define HD_CALIBRATION_OK 0x5000
#define HD_CALIBRATION_NEEDS_UPDATE 0x5001
#define HD_CALIBRATION_NEEDS_MANUAL_INPUT 0x5002
#define HD_CALIBRATION_ENCODER_RESET 0x1
#define HD_CALIBRATION_AUTO 0x2
#define HD_CALIBRATION_INKWELL 0x4

/* Scheduler */
#define HD_MAX_SCHEDULER_PRIORITY 65535
#define HD_MIN_SCHEDULER_PRIORITY 0
#define HD_CALLBACK_DONE 0
#define HD_CALLBACK_CONTINUE 1

#endif
