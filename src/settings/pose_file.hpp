// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hapticut/settings/motion.hpp"

namespace hapticut::settings {

/// Reads timed poses from a CSV file: a line of column names, then one pose per line, with increasing times. The
/// columns may have any order: `t_s`, `x_mm`, `y_mm`, `z_mm`; for the rotation a unit quaternion `qw`, `qx`, `qy`,
/// `qz`, or a matrix `r00`, `r01` ... `r22` (row, column), or neither. Upper and lower case are the same. Columns of
/// `--steps_csv`, of remarks (`comment`, `note`, `label`, `name`) and of row numbers (`index`, `row`, `step`, `frame`),
/// empty lines and lines that begin with # are skipped; other columns are refused.
/// @param rotation  rotation of every pose when the file has none
/// @throws Error `file:line: ...`
[[nodiscard]] std::vector<TimedPose> read_poses(const std::filesystem::path& path, const Mat3& rotation);

/// Reads timed poses from the text of a CSV file.
/// @param name  stands for the file name in messages
[[nodiscard]] std::vector<TimedPose> poses_of_text(std::string text, std::string name, const Mat3& rotation);

}  // namespace hapticut::settings
