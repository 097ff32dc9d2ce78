/* SPDX-License-Identifier: Apache-2.0 */
/* A stand-in for the DRD library of Force Dimension, see dhdc.h beside it. */
#ifndef HAPTICUT_STAND_IN_DRDC_H
#define HAPTICUT_STAND_IN_DRDC_H

#include "dhdc.h"

extern "C" {
int __SDK drdOpenID(char ID = -1);
bool __SDK drdIsInitialized(char ID = -1);
int __SDK drdAutoInit(char ID = -1);
int __SDK drdStop(bool frc = false, char ID = -1);
}

#endif
