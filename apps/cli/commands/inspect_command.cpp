// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>

#include "cli/commands/command.hpp"
#include "hapticut/core/units.hpp"
#include "reports/delivery.hpp"
#include "reports/json_file.hpp"
#include "reports/progress.hpp"
#include "reports/report.hpp"
#include "reports/shared_warnings.hpp"
#include "reports/table.hpp"
#include "settings/workpiece_settings.hpp"
#ifdef HAPTICUT_HAS_IMPORT
#include "settings/volume_source.hpp"
#endif

namespace hapticut::apps {

using namespace settings;

namespace {

struct InspectSettings {
  WorkpieceSettings workpiece;
  std::string json;
  std::optional<double> threshold;
};

bool has_materials(const WorkpieceSettings& s) {
  return !s.labels.empty() || s.unclaimed_labels || !s.fill_cavities.empty() || !s.grey.empty() || s.grade_low ||
         s.grade_high || !s.grade_at_low.empty() || !s.grade_at_high.empty();
}

#ifdef HAPTICUT_HAS_IMPORT
constexpr const char* kDoubt =
    "; files without a spacing often say so: compare the size, and set --spacing_mm if it is wrong";

/// Whether the file gives the spacing that is the default of most formats.
bool is_in_doubt(const WorkpieceSettings& s, const Vec3& spacing) {
  return !s.spacing_mm && spacing.isApproxToConstant(1 * units::mm);
}

/// The directions of the grid's axes in patient axes: left, back, head.
std::string axes_text(const Mat3& rotation) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += std::string(axis > 0 ? ", " : "") + "ijk"[axis] + " along";
    for (int row = 0; row < 3; ++row) {
      const double c = rotation(row, axis);
      (text += ' ') += rounded(std::abs(c) < 1e-9 ? 0 : c, 4);
    }
  }
  return text;
}

void inspect_volume(const InspectSettings& s, Delivery& delivery) {
  const VolumeSummary v = [&] {
    const ProgressBar progress("reading " + s.workpiece.source);
    return summarize_volume(s.workpiece, s.threshold);
  }();
  const Vec3 spacing = v.spacing / units::mm;
  const double voxel = spacing.prod();
  const Vec3 size = v.spacing.cwiseProduct(Vec3(v.dims[0], v.dims[1], v.dims[2]));
  Json report = {{"source", s.workpiece.source},
                 {"size_mm", in_mm(size)},
                 {"dims", v.dims},
                 {"spacing_mm", {spacing.x(), spacing.y(), spacing.z()}},
                 {"pose", to_json(v.X_WG)},
                 {"box", to_json(v.box)},
                 {"lowest", v.lowest},
                 {"highest", v.highest},
                 {"not_a_number", v.not_a_number},
                 {"padding", v.padding},
                 {"remarks", v.remarks}};
  Table table("hapticut inspect: " + s.workpiece.source);
  table.add("size", size_text(size));
  table.add("samples", dims_text(v.dims));
  table.add("spacing", size_text(v.spacing) + (is_in_doubt(s.workpiece, v.spacing) ? kDoubt : ""));
  table.add("box", box_text(v.box) + (v.X_WG.rotation.isIdentity(1e-9) ? "" : ", axes rotated"));
  table.add("axes", axes_text(v.X_WG.rotation));
  table.add("values", rounded(v.lowest, 6) + " to " + rounded(v.highest, 6) +
                          (v.not_a_number > 0 ? ", " + std::to_string(v.not_a_number) + " are not a number" : ""));
  if (v.padding > 0)
    table.add("padding",
              std::to_string(v.padding) + " samples of the file lie outside the field of view; treated as air");
  for (const std::string& remark : v.remarks) table.add("remark", remark);
  Json voxels = Json::object(), volumes = Json::object();
  for (const auto& [label, count] : v.voxels_by_label) {
    const std::string name = "label " + std::to_string(label);
    voxels[name] = count;
    volumes[name] = double(count) * voxel;
    table.add(name, std::to_string(count) + " voxels, " + rounded(double(count) * voxel, 6) + " mm^3");
  }
  report["voxels"] = voxels;
  report["volume_mm3"] = volumes;
  if (v.voxels_at_or_above) {
    report["voxels_at_or_above"] = *v.voxels_at_or_above;
    table.add("at or above " + rounded(*s.threshold), std::to_string(*v.voxels_at_or_above) + " voxels");
  }
  report["memory_bytes"] = v.memory_bytes;
  table.add("memory", bytes(v.memory_bytes));
  write_json(delivery, s.json, report);
  delivery.print(table.text());
}
#endif

void inspect_workpiece(const InspectSettings& s, Delivery& delivery) {
  const Workpiece workpiece = with_bar(s.workpiece.source, [&] { return make_workpiece(s.workpiece); });
  const WorkpieceSummary summary = summarize(s.workpiece.source, workpiece);
  Json report = to_json(summary, workpiece.materials());
  const double size = summary.voxel_size / units::mm;
  report["spacing_mm"] = {size, size, size};
  report["cutter"] = Json::object();

  Table table("hapticut inspect: " + summary.source);
  table.add("size", size_text(summary.size));
  table.add("voxels", dims_text(summary.dims) + " of " + rounded(size) + " mm");
  table.add("box", box_text(summary.box) + (summary.X_WV.rotation.isIdentity(1e-9) ? "" : ", axes rotated"));
  for (const MaterialAmount& amount : summary.amounts)
    if (amount.voxels > 0)
      table.add(workpiece.materials()[amount.material].name,
                std::to_string(amount.voxels) + " voxels, " + rounded(amount.volume / units::mm3, 6) + " mm^3, " +
                    rounded(1e3 * amount.mass) + " g, centre " + position_text(amount.center) + " mm");
  for (const auto& [kind, names] : names_by_cutter(workpiece.materials())) {
    for (const std::string& name : names) report["cutter"][name] = name_or_null(kind);
    table.add("constants", "for " + std::string(name_or_null(kind)) + ": " + text_of_names(names));
  }
  table.add("memory", bytes(summary.memory_bytes));
  write_json(delivery, s.json, report);
  delivery.print(table.text());
}

void run_inspect(const InspectSettings& s) {
  if (s.workpiece.source.empty()) throw UsageError("the workpiece is missing. Use: hapticut inspect SOURCE.");
  const bool as_volume = is_volume(s.workpiece) && !has_materials(s.workpiece);
  Delivery delivery({s.json});
  if (s.threshold && !as_volume)
    throw Error("--threshold applies to grey values of a volume, but " + s.workpiece.source +
                " is inspected as a workpiece. Leave it out.");
#ifdef HAPTICUT_HAS_IMPORT
  if (as_volume) {
    inspect_volume(s, delivery);
    return delivery.finish();
  }
#endif
  inspect_workpiece(s, delivery);
  delivery.finish();
}

}  // namespace

Command inspect_command() {
  auto settings = std::make_shared<InspectSettings>();
  tell_on_stderr(settings->workpiece);
  std::vector<Setting> all = settings_of(settings->workpiece);
  all.front().flag = "SOURCE";
  all.push_back(json_setting(settings->json));
  all.push_back(number("inspect.threshold", "--threshold", settings->threshold, Range::any(),
                       "volume: counts the voxels at or above this grey value"));
  return {"inspect", "Show the content of a file or a built-in workpiece", std::move(all),
          [settings] { run_inspect(*settings); }};
}

}  // namespace hapticut::apps
