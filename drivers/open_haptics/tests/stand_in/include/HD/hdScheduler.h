/* SPDX-License-Identifier: Apache-2.0 */
/* Part of a stand-in for the OpenHaptics device library, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one and none of its text. It drives nothing. */
#ifndef HAPTICUT_STAND_IN_HD_SCHEDULER_H
#define HAPTICUT_STAND_IN_HD_SCHEDULER_H

#include <HD/hdDefines.h>

typedef unsigned int HDCallbackCode;
typedef unsigned long HDSchedulerHandle;
typedef HDCallbackCode(HDCALLBACK* HDSchedulerCallback)(void* pUserData);

#ifdef __cplusplus
extern "C" {
#endif

HDAPI void HDAPIENTRY hdStartScheduler(void);
HDAPI void HDAPIENTRY hdStopScheduler(void);
HDAPI void HDAPIENTRY hdSetSchedulerRate(HDulong nRate);
HDAPI void HDAPIENTRY hdScheduleSynchronous(HDSchedulerCallback pCallback, void* pUserData, HDushort nPriority);
HDAPI HDSchedulerHandle HDAPIENTRY hdScheduleAsynchronous(HDSchedulerCallback pCallback, void* pUserData,
                                                          HDushort nPriority);
HDAPI void HDAPIENTRY hdUnschedule(HDSchedulerHandle hHandle);

#ifdef __cplusplus
}
#endif

#endif
