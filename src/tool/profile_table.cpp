// SPDX-License-Identifier: Apache-2.0
// Finds which curves decide in each cell. Each cell is sampled at 25 points with exact depths from the meridian. All
// rules with the curves near the cell are tried, and the one with the smallest error is kept. If a rule leaves out a
// curve that may give the depth, 1089 points bound the error. The cells are halved until the error is within the
// tolerance.
#include "hapticut/tool/profile_table.hpp"

#include <string>

#include "hapticut/core/errors.hpp"
#include "tool/meridian.hpp"

namespace hapticut::detail {
namespace {

constexpr double kCornerRadius = 1e-7;  // [1] radius of the circle that represents a hollow corner, over the size
constexpr double kExact = 4e-7;         // [1] error over the size: smaller errors count as none
constexpr double kSlabRounding = 1e-5;  // [1] slack over the size, above the slab height's rounding in single precision
constexpr std::size_t kMaxCells = 1U << 20U;
constexpr int kTile = 8;            // cells along the edge of a tile, for which curves are preselected
constexpr int kSamples = 5;         // along the edge of a cell, to choose
constexpr int kFineSamples = 33;    // along the edge of a cell, to bound the error
constexpr int kEdgeSamples = 1000;  // along an edge
// Two depths, each changing by at most kSmoothScale per unit of length, between a point and the nearest sample.
constexpr double kBetweenFineSamples = 2 * kSmoothScale * 0.70710678 / (kFineSamples - 1);  // [cell sizes] error

using Curves = std::vector<std::uint32_t>;

/// One sample of a cell: the result that the table should give there.
struct Sample {
  Vec2 at;
  double depth;   // [m] <= 0: no spring
  double margin;  // [m] from the surface, positive inside; infinite: far inside
};

class TableBuilder {
 public:
  explicit TableBuilder(const Meridian& meridian) : meridian_(meridian) {
    t_.radius = meridian.radius();
    t_.bottom = meridian.bottom();
    t_.top = meridian.top();
    t_.exact_pieces = meridian.pieces();
    t_.exact_corners = meridian.corners();
    write_curves();
    copy_to_single();
  }

  /// @param cell_size  [m] the first size, or half of the previous one
  void divide(double cell_size) {
    const std::vector<std::uint32_t> cells_before = std::move(t_.cells);
    const std::vector<bool> settled_before = std::move(settled_);
    const int columns_before = t_.columns;
    t_.cell_size = cell_size;
    t_.columns = int(std::ceil(t_.radius / cell_size));
    t_.rows = int(std::ceil((t_.top - t_.bottom) / cell_size));
    t_.cells.assign(std::size_t(t_.columns) * std::size_t(t_.rows), 0);
    settled_.assign(t_.cells.size(), false);
    for (std::size_t n = 0; !settled_before.empty() && n < t_.cells.size(); ++n) {
      const std::size_t row = n / std::size_t(t_.columns) / 2, column = n % std::size_t(t_.columns) / 2;
      const std::size_t parent = row * std::size_t(columns_before) + column;
      settled_[n] = settled_before[parent];
      if (settled_[n]) t_.cells[n] = cells_before[parent];
    }
    t_.error = 0;
    for (int row = 0; row < t_.rows; row += kTile)
      for (int column = 0; column < t_.columns; column += kTile) fill_tile(column, row);
  }

  [[nodiscard]] ProfileTable finish() {
    extend_cells();
    find_rule();
    write_slabs();
    return std::move(t_);
  }
  [[nodiscard]] double error() const { return t_.error; }

 private:
  void add_curve(const Vec2& p, const Vec2& m, double k, double scale) {
    ProfileCurves<double>& c = t_.exact_curves;
    c.rho.push_back(p.x());
    c.z.push_back(p.y());
    c.normal_rho.push_back(m.x());
    c.normal_z.push_back(m.y());
    c.curvature.push_back(k);
    c.scale.push_back(scale);
  }

  void write_curves() {
    add_curve(Vec2::Zero(), Vec2::Zero(), 0, 1);
    for (const MeridianCurve& curve : meridian_.curves()) {
      if (curve.kind == MeridianCurve::Kind::corner) {
        const double radius = kCornerRadius * meridian_.size();
        const Vec2 normal = left_of(curve.edge.end_tangent);
        add_curve(curve.point + radius * normal, normal, -1 / radius, curve.scale());
      } else {
        add_curve(curve.point, left_of(curve.edge.start_tangent), curve.edge.curvature, curve.scale());
      }
    }
    t_.curve_count = t_.exact_curves.rho.size();
    while (t_.exact_curves.rho.size() % 16 != 0) add_curve(Vec2::Zero(), Vec2::Zero(), 0, 1);
  }

  void copy_to_single() {
    const auto copy = [](const std::vector<double>& from, std::vector<float>& to) {
      to.assign(from.begin(), from.end());
    };
    copy(t_.exact_curves.rho, t_.curves.rho);
    copy(t_.exact_curves.z, t_.curves.z);
    copy(t_.exact_curves.normal_rho, t_.curves.normal_rho);
    copy(t_.exact_curves.normal_z, t_.curves.normal_z);
    copy(t_.exact_curves.curvature, t_.curves.curvature);
    copy(t_.exact_curves.scale, t_.curves.scale);
    for (const ProfileCorner<double>& c : t_.exact_corners) t_.corners.push_back({float(c.rho), float(c.z)});
    for (const ProfilePiece<double>& p : t_.exact_pieces)
      t_.pieces.push_back({float(p.rho_0), float(p.z_0), float(p.rho_1), float(p.z_1), float(p.center_rho),
                           float(p.center_z), float(p.radius), float(p.sense), float(p.side)});
  }

  /// Sets ProfileTable::cells_near, by spreading from cell to cell.
  void extend_cells() {
    t_.cells_near = t_.cells;
    std::vector<int> reached;  // ordered by distance; neighbours are visited later
    for (int n = 0; n < int(t_.cells.size()); ++n)
      if (t_.cells[std::size_t(n)] != 0) reached.push_back(n);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const int column = reached[next] % t_.columns, row = reached[next] / t_.columns;
      for (int j = std::max(row - 1, 0); j <= std::min(row + 1, t_.rows - 1); ++j)
        for (int i = std::max(column - 1, 0); i <= std::min(column + 1, t_.columns - 1); ++i) {
          std::uint32_t& cell = t_.cells_near[std::size_t(j) * std::size_t(t_.columns) + std::size_t(i)];
          if (cell != 0) continue;
          cell = t_.cells_near[std::size_t(reached[next])] | ProfileCell::kOutside;
          reached.push_back(j * t_.columns + i);
        }
    }
  }

  /// Sets ProfileTable::everywhere and lid.
  void find_rule() {
    Curves used;
    const auto use = [&](std::uint32_t curve) {
      if (curve != 0 && std::find(used.begin(), used.end(), curve) == used.end()) used.push_back(curve);
    };
    for (const std::uint32_t cell : t_.cells) {
      use(ProfileCell::first(cell));
      if (ProfileCell::rule(cell) != CellRule::first) use(ProfileCell::second(cell));
      if (used.size() > 3) return;
    }
    if (used.size() < 3) {
      find_rule_of(used, 0);
      return;
    }
    for (const std::uint32_t lid : used) {
      Curves others = used;
      std::erase(others, lid);
      if (find_rule_of(others, lid)) return;
    }
  }

  bool find_rule_of(const Curves& curves, std::uint32_t lid) {
    Curves rules;
    for (const std::uint32_t a : curves) rules.push_back(ProfileCell::pack(a, a, CellRule::first));
    for (const CellRule rule : {CellRule::sides, CellRule::nearer, CellRule::farther})
      for (const std::uint32_t a : curves)
        for (const std::uint32_t b : curves)
          if (a != b) rules.push_back(ProfileCell::pack(a, b, rule));
    t_.lid = lid;
    for (const std::uint32_t rule : rules) {
      t_.everywhere = rule;
      if (decides_everywhere(rule)) return true;
    }
    t_.everywhere = t_.lid = 0;
    return false;
  }

  [[nodiscard]] bool decides_everywhere(std::uint32_t rule) const {
    const ProfileSprings<double> springs(t_);
    const Curves all = all_curves();
    // The samples of a cell can miss a place where an edge cuts off little. On its edges a head has no depth.
    for (const MeridianEdge& e : meridian_.edges())
      for (int n = 0; n <= kEdgeSamples; ++n) {
        const double part = double(n) / kEdgeSamples;
        const Vec2 x = e.straight() ? Vec2(e.from + part * (e.to - e.from)) : e.at_angle(part * std::abs(e.sweep));
        if (is_bounded(x) && springs.decide(rule, x.x(), x.y()).spring.depth > kExact * meridian_.size()) return false;
      }
    for (int row = 0; row < t_.rows; ++row)
      for (int column = 0; column < t_.columns; ++column) {
        Curves nearest;
        const std::vector<Sample> samples = sample_cell(corner_of(column, row), kSamples, all, true, nearest);
        if (error_of(springs, samples, rule) > kExact * meridian_.size()) return false;
      }
    return true;
  }

  /// Writes the slabs. The largest rho of a piece in a slab is at an end of the slab or of the piece.
  void write_slabs() {
    constexpr int n = ProfileTable::kSlabs;
    const double height = (t_.top - t_.bottom) / n;
    const double slack = t_.error + kSlabRounding * meridian_.size();
    for (int slab = 0; slab < n; ++slab) {
      const double from = t_.bottom + slab * height - slack, to = t_.bottom + (slab + 1) * height + slack;
      double max_rho = 0;
      for (const ProfilePiece<double>& p : t_.exact_pieces) {
        const double low = std::max(from, std::min(p.z_0, p.z_1)), high = std::min(to, std::max(p.z_0, p.z_1));
        if (low > high) continue;
        if (p.z_0 == p.z_1)
          max_rho = std::max({max_rho, p.rho_0, p.rho_1});
        else
          for (const double z : {low, high}) max_rho = std::max(max_rho, ProfileSprings<double>::crossing(p, z));
      }
      const double radius = std::min(t_.radius, max_rho + slack);
      t_.slab_radius_squared[std::size_t(slab)] = float(radius * radius);
    }
  }

  /// Whether a point may have a spring.
  [[nodiscard]] bool is_bounded(const Vec2& x) const {
    return x.x() < t_.radius && x.y() > t_.bottom && x.y() < t_.top;
  }

  [[nodiscard]] Vec2 corner_of(int column, int row) const {
    return {column * t_.cell_size, t_.bottom + row * t_.cell_size};
  }

  /// [m] Signed depth below a curve's line or circle, also where the curve is not in charge.
  [[nodiscard]] double below(std::uint32_t curve, const Vec2& x) const {
    return meridian_.curves()[curve - 1].depth(x);
  }

  /// Those of `curves` that may give the depth somewhere within `reach` of a point: each depth changes by at most the
  /// curve's scale per unit of length.
  [[nodiscard]] Curves may_be_nearest(const Curves& curves, const Vec2& middle, double reach) const {
    double min_depth = std::numeric_limits<double>::infinity();
    double steepest = kSmoothScale;  // how fast the smallest depth grows
    for (const std::uint32_t n : curves) {
      const MeridianCurve& curve = meridian_.curves()[n - 1];
      const double depth = std::abs(below(n, middle));
      if (!(depth < min_depth) || !curve.in_charge(middle)) continue;
      min_depth = depth;
      steepest = curve.scale();
    }
    Curves kept;
    for (const std::uint32_t n : curves) {
      const MeridianCurve& curve = meridian_.curves()[n - 1];
      if (std::abs(below(n, middle)) <= min_depth + (steepest + curve.scale()) * reach &&
          curve.in_charge(middle, reach))
        kept.push_back(n);
    }
    return kept;
  }

  [[nodiscard]] Curves all_curves() const {
    Curves all(meridian_.curves().size());
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = std::uint32_t(n + 1);
    return all;
  }

  void fill_tile(int column, int row) {
    const Curves all = all_curves();
    const double half = kTile * t_.cell_size / 2;
    const Curves near = may_be_nearest(all, corner_of(column, row) + Vec2::Constant(half), std::sqrt(2.0) * half);
    for (int j = row; j < std::min(row + kTile, t_.rows); ++j)
      for (int i = column; i < std::min(column + kTile, t_.columns); ++i) {
        const std::size_t n = std::size_t(j) * std::size_t(t_.columns) + std::size_t(i);
        if (!settled_[n]) t_.cells[n] = best_cell(near, i, j);
      }
  }

  /// The best rule of a cell. An exact cell off the surface that has all curves near it is settled for its parts too.
  [[nodiscard]] std::uint32_t best_cell(const Curves& near_tile, int column, int row) {
    const std::size_t number = std::size_t(row) * std::size_t(t_.columns) + std::size_t(column);
    const ProfileSprings<double> springs(t_);
    const double h = t_.cell_size, reach = h * std::sqrt(0.5);
    const Vec2 corner = corner_of(column, row), middle = corner + Vec2::Constant(h / 2);
    const double margin = springs.margin(middle.x(), middle.y());
    if (margin < -reach * 1.001) {
      settled_[number] = true;
      return 0;
    }
    const bool on_surface = margin < reach * 1.001;
    const Curves near = may_be_nearest(near_tile, middle, reach);

    Curves nearest;
    const std::vector<Sample> samples = sample_cell(corner, kSamples, near, on_surface, nearest);
    if (on_surface) add_close_curves(near, middle, nearest);

    std::uint32_t best = 0;
    double min_error = error_of(springs, samples, 0);
    const double exact = kExact * meridian_.size();
    if (on_surface && min_error <= exact)
      min_error = 2 * exact;  // prefer a curve: the surface may pass between samples
    const auto consider = [&](std::uint32_t cell) {
      const double error = error_of(springs, samples, cell);
      if (error < min_error) {
        min_error = error;
        best = cell;
      }
      return min_error <= exact;
    };
    const auto choose = [&] {
      for (const std::uint32_t a : nearest)
        if (consider(ProfileCell::pack(a, a, CellRule::first))) return;
      for (const CellRule rule : {CellRule::sides, CellRule::nearer, CellRule::farther})
        for (const std::uint32_t a : nearest)
          for (const std::uint32_t b : nearest)
            if (a != b && consider(ProfileCell::pack(a, b, rule))) return;
    };
    choose();
    const double bound = bound_of(best, corner, near, on_surface);
    t_.error = std::max(t_.error, bound);
    settled_[number] = !on_surface && bound <= exact && is_complete(best, near);
    return best;
  }

  /// Whether a cell contains all of the curves.
  [[nodiscard]] static bool is_complete(std::uint32_t cell, const Curves& near) {
    const std::uint32_t a = ProfileCell::first(cell), b = ProfileCell::second(cell);
    return std::all_of(near.begin(), near.end(), [&](std::uint32_t n) { return n == a || n == b; });
  }

  [[nodiscard]] double bound_of(std::uint32_t cell, const Vec2& corner, const Curves& near, bool on_surface) const {
    Curves nearest;
    const std::vector<Sample> samples =
        sample_cell(corner, is_complete(cell, near) ? kSamples : kFineSamples, near, on_surface, nearest);
    const double error = error_of(ProfileSprings<double>(t_), samples, cell);
    return error <= kExact * meridian_.size() ? error : error + kBetweenFineSamples * t_.cell_size;
  }

  /// Samples a cell, and collects in `nearest` the curves that give the depth at one of the samples.
  [[nodiscard]] std::vector<Sample> sample_cell(const Vec2& corner, int count, const Curves& near, bool on_surface,
                                                Curves& nearest) const {
    const ProfileSprings<double> springs(t_);
    std::vector<Sample> samples;
    for (int n = 0; n < count * count; ++n) {
      const Vec2 x = corner + t_.cell_size / (count - 1) * Vec2(n % count, n / count);
      if (!is_bounded(x)) continue;
      Sample s{x, -1, std::numeric_limits<double>::infinity()};
      if (on_surface) s.margin = springs.margin(x.x(), x.y());
      if (!on_surface || s.margin > 0) {
        double min_depth = std::numeric_limits<double>::infinity();
        std::uint32_t best = 0;
        for (const std::uint32_t c : near) {
          if (!meridian_.curves()[c - 1].in_charge(x)) continue;
          const double depth = below(c, x);
          if (std::abs(depth) >= min_depth) continue;
          min_depth = std::abs(depth);
          s.depth = depth;
          best = c;
        }
        if (best != 0 && std::find(nearest.begin(), nearest.end(), best) == nearest.end()) nearest.push_back(best);
      }
      samples.push_back(s);
    }
    return samples;
  }

  /// Adds the four curves closest to the middle: they bound the head in a cell on its surface, even if no sample did.
  void add_close_curves(const Curves& near, const Vec2& middle, Curves& nearest) const {
    Curves close = near;
    std::sort(close.begin(), close.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::abs(below(a, middle)) < std::abs(below(b, middle));
    });
    if (close.size() > 4) close.erase(close.begin() + 4, close.end());
    for (const std::uint32_t c : close)
      if (std::find(nearest.begin(), nearest.end(), c) == nearest.end()) nearest.push_back(c);
  }

  /// [m] The largest distance by which a sample must move for the cell to be correct there.
  [[nodiscard]] static double error_of(const ProfileSprings<double>& springs, const std::vector<Sample>& samples,
                                       std::uint32_t cell) {
    double error = 0;
    for (const Sample& s : samples) {
      const double depth = springs.decide(cell, s.at.x(), s.at.y()).spring.depth;
      const double got = std::max(0.0, depth), want = std::max(0.0, s.depth);
      const double difference = std::abs(got - want);
      error = std::max(error, (got > 0) != (want > 0) ? std::min(difference, std::abs(s.margin)) : difference);
    }
    return error;
  }

  const Meridian& meridian_;
  ProfileTable t_;
  std::vector<bool> settled_;  // by cell
};

}  // namespace

ProfileTable make_profile_table(const Meridian& meridian, double tolerance) {
  const double height = meridian.top() - meridian.bottom(), smaller = std::min(meridian.radius(), height);
  TableBuilder builder(meridian);
  for (double cell_size = smaller / 16;; cell_size /= 2) {
    const double cells = (meridian.radius() / cell_size + 1) * (height / cell_size + 1);
    if (cells > double(kMaxCells))
      throw Error("a tolerance of " + format_number(tolerance) + " needs more than " + std::to_string(kMaxCells) +
                  " cells for this profile. Give the profile fewer small edges, or a larger tolerance.");
    builder.divide(cell_size);
    if (builder.error() <= tolerance * smaller) return builder.finish();
  }
}

}  // namespace hapticut::detail
