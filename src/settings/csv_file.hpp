// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/sentence.hpp"

namespace hapticut::settings {

/// Reads the lines of a CSV file: a line of column names, then lines with as many cells. It accepts what spreadsheets
/// of any country write:
/// - Commas, semicolons, tabs or blanks separate the columns. The first line (or Excel's `sep=;` before it) decides.
/// - A comma may be the decimal point. Numbers that could also have a mark for thousands are refused when no other
///   number settles it.
/// - Cells may be in quotes.
///
/// Empty lines, lines that begin with #, blanks around a cell and a UTF-8 byte order mark are skipped.
class CsvFile {
 public:
  /// @param what     the kind of file: "file of poses"
  /// @param setting  what names the file: `path.file`, "hapticut calibrate"
  /// @throws Error when the file cannot be read
  CsvFile(const std::filesystem::path& path, const std::string& what, const Sentence& setting);

  /// Reads a text in memory.
  /// @param name  stands for the file name in messages
  CsvFile(std::string text, std::string name);

  /// Reads the cells of the next line.
  /// @return false at the end of the file
  /// @throws Error when a line has another number of cells than the first; at the end, when it is unclear whether the
  ///         numbers have decimals or marks for thousands
  bool next(std::vector<std::string>& cells);

  /// The number in a cell; nullopt when the cell is no number.
  /// @throws Error when some numbers have commas and others points
  std::optional<double> number(std::string cell);

  /// The names of the columns, from the first line. Upper and lower case are the same.
  /// @param must  requirement in the message about an empty file: "name the columns t_s, x_mm ..."
  /// @throws Error also when two columns have the same name
  const std::vector<std::string>& read_names(const std::string& must);

  /// Refuses columns of other names, because what they say would be left out. Spreadsheets add columns without a name,
  /// which are skipped.
  /// @param known   names of the columns that are read
  /// @param skipped  names of further columns that may be there
  /// @throws Error that names the column, the known ones and the nearest of them
  void require_known(const std::vector<std::string>& known, const std::vector<std::string>& skipped = {}) const;

  /// Index of a column; nullopt when the file has no column of that name.
  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;

  /// The finite number in one cell of a line.
  /// @throws Error that names the column and its content
  double number_at(const std::vector<std::string>& cells, std::size_t column);

  /// @throws FileError with the number of the line
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
