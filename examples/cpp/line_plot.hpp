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
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
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
  constexpr double kWidth = 420, kHeight = 300, kLeft = 60, kTop = 50, kInner = 330, kInnerHeight = 200;
  constexpr std::array<const char*, 4> kColors = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd"};
  const std::size_t panels = (plot.lines.size() + plot.lines_per_panel - 1) / plot.lines_per_panel;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth * double(panels) << "\" height=\"" << kHeight
      << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      << "<text x=\"10\" y=\"20\" font-size=\"15\">" << plot.title << "</text>\n";
  for (std::size_t panel = 0; panel < panels; ++panel) {
    const std::size_t first = panel * plot.lines_per_panel;
    const std::size_t last = std::min(plot.lines.size(), first + plot.lines_per_panel);
    double largest = 0;
    for (std::size_t n = first; n < last; ++n)
      for (const double value : plot.lines[n].values) largest = std::max(largest, value);
    if (largest == 0) largest = 1;
    const double x0 = kWidth * double(panel) + kLeft, y0 = kTop + kInnerHeight;
    out << "<path d=\"M" << x0 << " " << kTop << "V" << y0 << "H" << x0 + kInner
        << "\" fill=\"none\" stroke=\"black\"/>\n";
    for (int tick = 0; tick <= 4; ++tick) {
      const double y = y0 - kInnerHeight * tick / 4;
      out << "<text x=\"" << x0 - 5 << "\" y=\"" << y + 4 << "\" text-anchor=\"end\">" << shortened(largest * tick / 4)
          << "</text><path d=\"M" << x0 << " " << y << "h" << kInner << "\" stroke=\"#ddd\"/>\n";
    }
    out << "<text x=\"" << x0 + kInner / 2 << "\" y=\"" << y0 + 30 << "\" text-anchor=\"middle\">" << plot.x_label
        << "</text>\n";
    for (std::size_t n = first; n < last; ++n) {
      const auto& values = plot.lines[n].values;
      const char* color = kColors[(n - first) % kColors.size()];
      out << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\"";
      for (std::size_t i = 0; i < values.size(); ++i)
        out << x0 + kInner * double(i) / std::max<double>(1, double(values.size() - 1)) << ","
            << y0 - kInnerHeight * values[i] / largest << " ";
      out << "\"/>\n<text x=\"" << x0 + 10 << "\" y=\"" << kTop + 14 * double(n - first + 1) << "\" fill=\"" << color
          << "\">" << plot.lines[n].name << "</text>\n";
    }
  }
  out << "</svg>\n";
}
