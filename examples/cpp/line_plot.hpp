// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

/// One value for each step.
struct Line {
  std::string name;
  std::vector<double> values;
};

/// Lines that share a vertical axis.
struct Panel {
  std::string title;
  std::vector<Line> lines;
};

inline std::string shortened(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// The smallest round number q with 4 q >= value: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten.
inline double round_quarter(double value) {
  const double power = std::pow(10, std::floor(std::log10(value / 4)));
  for (const double digit : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (4 * digit * power >= value) return digit * power;
  return 10 * power;
}

inline void write_csv(std::ostream& out, const std::string& x_label, const std::vector<Line>& lines) {
  out << x_label;
  for (const Line& line : lines) out << ",\"" << line.name << '"';
  for (std::size_t i = 0; i < lines.front().values.size(); ++i) {
    out << "\n" << i + 1;
    for (const Line& line : lines) out << "," << line.values[i];
  }
  out << "\n";
}

/// Writes panels as an SVG file, `columns` in each row.
inline void write_svg(std::ostream& out, const std::string& x_label, const std::vector<Panel>& panels,
                      std::size_t columns) {
  constexpr double kWidth = 400, kHeight = 330, kLeft = 60, kTop = 40, kInner = 320, kInnerHeight = 220;
  constexpr std::array<const char*, 4> kColors = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd"};
  const auto write = [&](double x, double y, const std::string& text, const std::string& style) {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << text << "</text>\n";
  };
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth * double(columns) << "\" height=\""
      << kHeight * double(rows) << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (std::size_t n = 0; n < panels.size(); ++n) {
    const std::vector<Line>& lines = panels[n].lines;
    double max_value = 0;
    for (const Line& line : lines)
      for (const double value : line.values) max_value = std::max(max_value, value);
    const double quarter = max_value > 0 ? round_quarter(max_value) : 0.25;
    const double x0 = kWidth * double(n % columns) + kLeft;
    const double top = kHeight * double(n / columns) + kTop, y0 = top + kInnerHeight;
    const std::size_t steps = lines.front().values.size();
    const auto x_of = [&](std::size_t i) { return x0 + kInner * double(i) / std::max(1.0, double(steps) - 1); };
    write(x0, top - 15, panels[n].title, "font-size=\"15\"");
    out << "<path d=\"M" << x0 << " " << top << "V" << y0 << "H" << x0 + kInner
        << "\" fill=\"none\" stroke=\"black\"/>\n";
    for (int tick = 0; tick <= 4; ++tick) {
      const double y = y0 - kInnerHeight * tick / 4;
      write(x0 - 5, y + 4, shortened(quarter * tick), "text-anchor=\"end\"");
      out << "<path d=\"M" << x0 << " " << y << "h" << kInner << "\" stroke=\"#ddd\"/>\n";
    }
    for (std::size_t i = 0; i < steps; ++i) write(x_of(i), y0 + 16, std::to_string(i + 1), "text-anchor=\"middle\"");
    write(x0 + kInner / 2, y0 + 34, x_label, "text-anchor=\"middle\"");
    for (std::size_t line = 0; line < lines.size(); ++line) {
      const std::string color = kColors[line % kColors.size()];
      out << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\"";
      for (std::size_t i = 0; i < steps; ++i)
        out << x_of(i) << "," << y0 - kInnerHeight * lines[line].values[i] / (4 * quarter) << " ";
      out << "\"/>\n";
      write(x0 + kInner * double(line) / double(lines.size()), y0 + 58, lines[line].name, "fill=\"" + color + "\"");
    }
  }
  out << "</svg>\n";
}

/// Opens a file and calls `write` with the stream.
template <class Write>
void write_to(const std::filesystem::path& path, const Write& write) {
  std::ofstream out(path);
  write(out);
  if (!out) throw std::runtime_error("cannot write " + path.string() + ". Choose a folder that can be written to.");
}
