// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hapticut::settings {

/// The lines of a CSV file that a user wrote: a line of column names, then lines of as many cells. Spreadsheets of
/// every country write them: columns are separated by commas, semicolons, tabs or blanks, which the first line tells
/// (or Excel's `sep=;` before it), and a comma is a decimal point, unless all numbers that have one may mark thousands
/// by it. Cells may be in quotes. Empty lines and those that begin with # are skipped, as are blanks around a cell and
/// the mark that some programs put before a text in UTF-8.
class CsvFile {
 public:
  /// @param what  what the file is, and where its name was given: "file of poses", "--poses"
  /// @throws Error when it cannot be read
  CsvFile(const std::filesystem::path& path, const std::string& what, const std::string& flag);

  /// The same of a text.
  /// @param name  in messages, where that of a file would be
  CsvFile(std::string text, std::string name);

  /// The cells of the next line; false: there is none.
  /// @throws Error when they are not as many as in the first line; at the end also when it is not clear whether the
  ///         numbers have decimals or mark thousands
  bool next(std::vector<std::string>& cells);

  /// The number in a cell; nothing where there is none.
  /// @throws Error when some numbers have commas, others points
  std::optional<double> number(std::string cell);

  /// The names of the columns, from the first line.
  /// @param must  what is said of that line where the file is empty: "name the columns t_s, x_mm ..."
  /// @throws Error also when two columns have the same name
  const std::vector<std::string>& read_names(const std::string& must);

  /// Where a column is; nothing where the file has none of that name.
  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;

  /// The finite number in a cell of a line.
  /// @throws Error naming the column and what is there
  double number_at(const std::vector<std::string>& cells, std::size_t column);

  /// @throws Error that begins with file and line
  [[noreturn]] void fail(const std::string& message) const;

 private:
  bool next_line(std::string& line);
  void require_decimals();
  std::vector<std::string> cells_of(const std::string& line) const;

  std::string name_;
  std::unique_ptr<std::istream> stream_;
  int line_ = 0;
  std::size_t columns_ = 0;
  std::vector<std::string> names_;
  char separator_ = 0;  // 0: not known yet
  bool has_points_ = false, has_commas_ = false, has_decimals_ = false;
  std::string doubtful_;  // the first number that may mark thousands
  int doubtful_line_ = 0;
};

}  // namespace hapticut::settings
