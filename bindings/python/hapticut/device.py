# SPDX-License-Identifier: Apache-2.0
"""Haptic devices, simulated devices, and models of devices and hands."""
from ._export import export
from ._hapticut import (
    # Devices and runs
    Device as Device,
    RunOptions as RunOptions,
    RunReport as RunReport,
    describe as describe,
    device_drivers as device_drivers,
    open_device as open_device,

    # Data from and to a device
    DeviceCapabilities as DeviceCapabilities,
    DeviceCommand as DeviceCommand,
    DeviceFault as DeviceFault,
    DeviceOutput as DeviceOutput,
    DeviceState as DeviceState,
    ModelContact as ModelContact,
    OutputChange as OutputChange,

    # Simulated devices
    MockDevice as MockDevice,
    MockOptions as MockOptions,
    MouseDevice as MouseDevice,
    MouseOptions as MouseOptions,
    MoveKey as MoveKey,
    PlaybackDevice as PlaybackDevice,
    open_mock as open_mock,
    scripted_path as scripted_path,

    # Models of devices and hands
    DeviceModel as DeviceModel,
    HandModel as HandModel,
    Plant as Plant,
    PlantOptions as PlantOptions,
    capabilities as capabilities,
    device_model as device_model,
    device_models as device_models,
    hand_model as hand_model,
    hand_models as hand_models,
)

export(__name__)
