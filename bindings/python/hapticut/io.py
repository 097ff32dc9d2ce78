# SPDX-License-Identifier: Apache-2.0
"""Files: volumes, meshes, voxels, recordings and pictures."""
from typing import TYPE_CHECKING

from ._export import export
from ._hapticut import (
    kWithIo as kWithIo,

    # Voxels
    VdbImport as VdbImport,
    load_vdb as load_vdb,
    save_vdb as save_vdb,
)

if TYPE_CHECKING or kWithIo:
    from ._hapticut import (
        # Volumes
        RawLayout as RawLayout,
        ValueType as ValueType,
        VolumeReadOptions as VolumeReadOptions,
        kMaxVolumeSamples as kMaxVolumeSamples,
        read_color_slices as read_color_slices,
        read_grey_volume as read_grey_volume,
        read_label_volume as read_label_volume,
        read_raw_grey_volume as read_raw_grey_volume,
        read_raw_label_volume as read_raw_label_volume,
        write_nrrd as write_nrrd,

        # Meshes and pictures
        NamedMesh as NamedMesh,
        PictureOptions as PictureOptions,
        colored as colored,
        material_color as material_color,
        read_mesh as read_mesh,
        write_obj as write_obj,
        write_picture as write_picture,
        write_ply as write_ply,
        write_stl as write_stl,

        # Recordings
        PlaybackRange as PlaybackRange,
        RecordedEffects as RecordedEffects,
        Recorder as Recorder,
        RecorderOptions as RecorderOptions,
        Recording as Recording,
        RecordingInfo as RecordingInfo,
        ReplayDifference as ReplayDifference,
        ReplayReport as ReplayReport,
        kMaxPlayedSteps as kMaxPlayedSteps,
        kRecordingFormat as kRecordingFormat,
        open_playback as open_playback,
        read_recording as read_recording,
        replay as replay,
        simulation_of as simulation_of,
        write_csv as write_csv,
        write_npz as write_npz,
        write_wav as write_wav,
    )

export(__name__)
