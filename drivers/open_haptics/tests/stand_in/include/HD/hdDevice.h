/* SPDX-License-Identifier: Apache-2.0 */
/* Part of a stand-in for the OpenHaptics device library, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one and none of its text. It drives nothing. */
#ifndef HAPTICUT_STAND_IN_HD_DEVICE_H
#define HAPTICUT_STAND_IN_HD_DEVICE_H

#include <HD/hdDefines.h>

#ifdef __cplusplus
extern "C" {
#endif

HDAPI HHD HDAPIENTRY hdInitDevice(HDstring pConfigName);
HDAPI void HDAPIENTRY hdMakeCurrentDevice(HHD hHD);
HDAPI void HDAPIENTRY hdDisableDevice(HHD hHD);
HDAPI HHD HDAPIENTRY hdGetCurrentDevice(void);
HDAPI void HDAPIENTRY hdBeginFrame(HHD hHD);
HDAPI void HDAPIENTRY hdEndFrame(HHD hHD);
HDAPI HDErrorInfo HDAPIENTRY hdGetError(void);
HDAPI HDstring HDAPIENTRY hdGetErrorString(HDerror errorCode);
HDAPI void HDAPIENTRY hdEnable(HDenum cap);
HDAPI void HDAPIENTRY hdDisable(HDenum cap);
HDAPI void HDAPIENTRY hdGetIntegerv(HDenum pname, HDint* params);
HDAPI void HDAPIENTRY hdGetDoublev(HDenum pname, HDdouble* params);
HDAPI HDstring HDAPIENTRY hdGetString(HDenum pname);
HDAPI void HDAPIENTRY hdSetDoublev(HDenum pname, const HDdouble* params);
HDAPI HDenum HDAPIENTRY hdCheckCalibration(void);
HDAPI void HDAPIENTRY hdUpdateCalibration(HDenum style);
HDAPI HDboolean HDAPIENTRY hdDeploymentLicense(const char* vendorName, const char* applicationName,
                                               const char* password);

#ifdef __cplusplus
}
#endif

#endif
