# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Pose:
    """The pose functions of C++ for (4, 4) arrays: ``X_AC = X_AB @ X_BC``."""

    @staticmethod
    def from_translation(translation: ArrayLike) -> NDArray[np.float64]:
        """A pose with a translation only.

        Parameters
        ----------
        translation
            [m] (3,), or (n, 3) for n poses.

        Returns
        -------
        numpy.ndarray
            (4, 4), or (n, 4, 4).
        """
        p = np.asarray(translation, dtype=np.float64)
        if p.shape[-1:] != (3,):
            raise ValueError(f"translation has shape {p.shape}; it must be (3,) or (n, 3).")
        X = np.zeros((*p.shape[:-1], 4, 4))
        X[..., range(4), range(4)] = 1
        X[..., :3, 3] = p
        return X

    @staticmethod
    def inverse(X_AB: ArrayLike) -> NDArray[np.float64]:
        """The inverse ``X_BA`` of a pose or of poses (..., 4, 4).

        Raises
        ------
        ValueError
            When a matrix is no rigid transform.
        """
        X = np.asarray(X_AB, dtype=np.float64)
        if X.shape[-2:] != (4, 4):
            raise ValueError(f"X_AB has shape {X.shape}; it must be (..., 4, 4).")
        R = X[..., :3, :3]
        if not (np.allclose(R @ np.swapaxes(R, -1, -2), np.eye(3), atol=1e-6) and np.all(X[..., 3, :] == (0, 0, 0, 1))):
            raise ValueError("X_AB is not a rigid transform: its rotation must be orthonormal, its last row 0 0 0 1.")
        inverse = np.zeros_like(X)
        inverse[..., :3, :3] = np.swapaxes(R, -1, -2)
        inverse[..., :3, 3] = -np.einsum("...ji,...j->...i", R, X[..., :3, 3])
        inverse[..., 3, 3] = 1
        return inverse
