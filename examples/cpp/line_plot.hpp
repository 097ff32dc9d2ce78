// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

/// A picture of a few lines over the same steps, in panels side by side, as an SVG file; and the numbers as CSV.
struct LinePlot {
  struct Line {
    std::string name;
    std::vector<double> values;
  };
  std::string title, x_label;
  std::vector<Line> lines;
  std::size_t lines_per_panel;  // each panel has a vertical axis of its own
};

inline std::string shortened(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// The least round number such that four of it reach a value: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten.
inline double round_quarter(double value) {
  const double power = std::pow(10, std::floor(std::log10(value / 4)));
  for (const double digit : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (4 * digit * power >= value) return digit * power;
  return 10 * power;
}

inline void write_csv(std::ostream& out, const std::string& x_label, const std::vector<LinePlot::Line>& lines) {
  out << x_label;
  for (const auto& line : lines) out << ",\"" << line.name << '"';
  for (std::size_t i = 0; i < lines.front().values.size(); ++i) {
    out << "\n" << i + 1;
    for (const auto& line : lines) out << "," << line.values[i];
  }
  out << "\n";
}

inline void write_svg(std::ostream& out, const LinePlot& plot) {
  constexpr double kWidth = 450, kHeight = 340, kLeft = 70, kTop = 40, kInner = 350, kInnerHeight = 220;
  constexpr std::array<const char*, 4> kColors = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd"};
  const std::size_t panels = (plot.lines.size() + plot.lines_per_panel - 1) / plot.lines_per_panel;
  const auto write = [&](double x, double y, const std::string& text, const std::string& style) {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << text << "</text>\n";
  };
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth * double(panels) << "\" height=\"" << kHeight
      << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  write(10, 20, plot.title, "font-size=\"15\"");
  for (std::size_t panel = 0; panel < panels; ++panel) {
    const std::size_t first = panel * plot.lines_per_panel;
    const std::size_t last = std::min(plot.lines.size(), first + plot.lines_per_panel);
    double largest = 0;
    for (std::size_t n = first; n < last; ++n)
      for (const double value : plot.lines[n].values) largest = std::max(largest, value);
    const double quarter = largest > 0 ? round_quarter(largest) : 0.25;
    const double x0 = kWidth * double(panel) + kLeft, y0 = kTop + kInnerHeight;
    const std::size_t steps = plot.lines[first].values.size();
    const auto x_of = [&](std::size_t i) { return x0 + kInner * double(i) / std::max(1.0, double(steps) - 1); };
    out << "<path d=\"M" << x0 << " " << kTop << "V" << y0 << "H" << x0 + kInner
        << "\" fill=\"none\" stroke=\"black\"/>\n";
    for (int tick = 0; tick <= 4; ++tick) {
      const double y = y0 - kInnerHeight * tick / 4;
      write(x0 - 5, y + 4, shortened(quarter * tick), "text-anchor=\"end\"");
      out << "<path d=\"M" << x0 << " " << y << "h" << kInner << "\" stroke=\"#ddd\"/>\n";
    }
    for (std::size_t i = 0; i < steps; ++i) write(x_of(i), y0 + 16, std::to_string(i + 1), "text-anchor=\"middle\"");
    write(x0 + kInner / 2, y0 + 34, plot.x_label, "text-anchor=\"middle\"");
    for (std::size_t n = first; n < last; ++n) {
      const std::string color = kColors[(n - first) % kColors.size()];
      out << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\"";
      for (std::size_t i = 0; i < plot.lines[n].values.size(); ++i)
        out << x_of(i) << "," << y0 - kInnerHeight * plot.lines[n].values[i] / (4 * quarter) << " ";
      out << "\"/>\n";
      const double share = double(n - first) / double(plot.lines_per_panel);
      write(x0 + kInner * share, y0 + 60, plot.lines[n].name, "fill=\"" + color + "\"");
    }
  }
  out << "</svg>\n";
}
