// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "line_plot.hpp"

/// Values on a section, row by row from the top. NaN stays white.
struct Section {
  std::string title;
  std::vector<std::vector<double>> values;
};

/// Colour from blue through white, yellow and red to black in forty steps, as "#rrggbb".
inline std::string heat_color(double share) {
  struct Stop {
    double at;
    std::array<double, 3> rgb;
  };
  constexpr std::array<Stop, 5> kStops = {
      {{0, {60, 110, 220}}, {0.18, {225, 232, 240}}, {0.4, {250, 200, 60}}, {0.7, {215, 40, 30}}, {1, {70, 0, 10}}}};
  const double s = std::round(40 * std::clamp(share, 0.0, 1.0)) / 40;
  std::size_t n = 1;
  while (n + 1 < kStops.size() && s > kStops[n].at) ++n;
  const double part = (s - kStops[n - 1].at) / (kStops[n].at - kStops[n - 1].at);
  std::array<char, 8> text{};
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = int(std::lround(kStops[n - 1].rgb[c] + part * (kStops[n].rgb[c] - kStops[n - 1].rgb[c])));
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  return text.data();
}

/// Writes sections side by side as an SVG file with a colour scale. Neighbours of one colour form one rectangle.
inline void write_section_svg(std::ostream& out, const std::vector<Section>& sections, double low, double high,
                              const std::string& unit) {
  constexpr double kPixel = 4, kGap = 30, kTop = 40, kScale = 90;
  const double width = kPixel * double(sections.front().values.front().size());
  const double height = kPixel * double(sections.front().values.size());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << (width + kGap) * double(sections.size()) + kScale
      << "\" height=\"" << height + kTop + kGap
      << "\" font-family=\"sans-serif\" font-size=\"13\" shape-rendering=\"crispEdges\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  const auto rectangle = [&](double x, double y, double w, double h, const std::string& color) {
    out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << w << "\" height=\"" << h << "\" fill=\"" << color
        << "\"/>\n";
  };
  double x0 = kGap / 2;
  for (const Section& section : sections) {
    out << "<text x=\"" << x0 << "\" y=\"" << kTop - 14 << "\">" << section.title << "</text>\n";
    for (std::size_t row = 0; row < section.values.size(); ++row) {
      const std::vector<double>& line = section.values[row];
      for (std::size_t i = 0, end = 0; i < line.size(); i = end) {
        const auto color = [&](std::size_t n) {
          return std::isnan(line[n]) ? std::string("white") : heat_color((line[n] - low) / (high - low));
        };
        for (end = i + 1; end < line.size() && color(end) == color(i);) ++end;
        rectangle(x0 + kPixel * double(i), kTop + kPixel * double(row), kPixel * double(end - i), kPixel, color(i));
      }
    }
    x0 += width + kGap;
  }
  for (int n = 0; n < 100; ++n)
    rectangle(x0, kTop + height * (99 - n) / 100, 16, height / 100 + 1, heat_color((n + 0.5) / 100));
  for (int n = 0; n <= 4; ++n)
    out << "<text x=\"" << x0 + 20 << "\" y=\"" << kTop + height * (4 - n) / 4 + 5 << "\">"
        << shortened(low + (high - low) * n / 4) << (n == 4 ? " " + unit : "") << "</text>\n";
  out << "</svg>\n";
}
