// SPDX-License-Identifier: Apache-2.0
// The program: makes flags from the settings of each subcommand, applies the settings file, then the flags, and runs
// the command.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/little_memory.hpp"
#include "core/lack_of_memory.hpp"
#include "hapticut/core/build_info.hpp"
#include "io/atomic_file.hpp"
#include "reports/delivery.hpp"
#include "reports/flag_words.hpp"
#include "settings/settings_file.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

/// A subcommand and the texts given to its flags.
struct Registered {
  Command command;
  CLI::App* app = nullptr;
  std::vector<std::string> settings_files = {};
  std::deque<std::vector<std::string>> texts = {};  // one element per setting
};

void register_flags(Registered& entry) {
  entry.app->add_option("--settings", entry.settings_files, "TOML file with settings; flags override it")
      ->type_name("FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  for (const Setting& setting : entry.command.settings) {
    std::vector<std::string>& texts = entry.texts.emplace_back();
    if (setting.flag.empty()) continue;
    const std::string help = setting.meaning + " (" + setting.allowed + ")";
    CLI::Option* option = setting.kind == Setting::Kind::boolean ? entry.app->add_flag(setting.flag, texts, help)
                                                                 : entry.app->add_option(setting.flag, texts, help);
    if (setting.kind == Setting::Kind::boolean) {
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    } else {
      option->type_name("")->expected(1)->allow_extra_args(false);
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);  // apply_flag checks
    }
    const std::size_t dot = setting.key.find('.');
    if (dot != std::string::npos) option->group("[" + setting.key.substr(0, dot) + "]");
  }
}

std::string name_of(const Setting& setting) { return setting.flag.empty() ? setting.key : setting.flag; }

/// A run must not overwrite its inputs, and each output needs a separate file.
/// @throws Error that names both settings
void require_own_files(const std::vector<Setting>& settings, const std::string& settings_file) {
  std::map<std::filesystem::path, std::string> taken;  // file -> setting that names it
  const auto place_of = [](const std::filesystem::path& file) {
    std::error_code unknown;
    const std::filesystem::path path = place_behind_links(std::filesystem::absolute(file));
    const std::filesystem::path place = std::filesystem::weakly_canonical(path, unknown);
    return unknown ? path : place;
  };
  if (!settings_file.empty()) taken[place_of(settings_file)] = "--settings";
  const auto is_output = [](const Setting& setting) { return setting.key.starts_with("output."); };
  for (const Setting& setting : settings)
    if (setting.files && !is_output(setting))
      for (const std::filesystem::path& file : setting.files()) taken.try_emplace(place_of(file), name_of(setting));
  for (const Setting& setting : settings) {
    if (!setting.files || !is_output(setting)) continue;
    for (const std::filesystem::path& file : setting.files()) {
      const std::filesystem::path place = place_of(file);
      const auto [other, is_new] = taken.try_emplace(place, name_of(setting));
      std::error_code unknown;
      if (!is_new && file == "-")
        throw Error(name_of(setting) + " and " + other->second +
                    " both go to standard output. Give one of them a file.");
      if (!is_new && (std::filesystem::is_regular_file(place, unknown) || !std::filesystem::exists(place, unknown)))
        throw Error(name_of(setting) + " would overwrite '" + file.string() + "', the file of " + other->second +
                    ". Give it another name.");
    }
  }
}

/// The message for a key, or a table, that only other commands have; empty if no command has it.
std::string of_other_commands(const std::deque<Registered>& entries, const Command& command, const std::string& key) {
  bool is_table = false;
  std::vector<std::string> others;
  for (const Registered& entry : entries) {
    const std::vector<Setting>& settings = entry.command.settings;
    const bool has_in_it =
        std::any_of(settings.begin(), settings.end(), [&](const Setting& s) { return s.key.starts_with(key + "."); });
    if (has_in_it || std::any_of(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; }))
      others.push_back(entry.command.name);
    is_table = is_table || has_in_it;
  }
  if (others.empty()) return "";
  return command.name + " takes no " + (is_table ? "[" + key + "]" : key) + "; it is a " +
         (is_table ? "table" : "setting") + " of " + joined(others, " and ") + ". Leave it out.";
}

void run(const std::deque<Registered>& entries, const Registered& entry) {
  const std::vector<Setting>& settings = entry.command.settings;
  if (entry.settings_files.size() > 1)
    throw UsageError("--settings is given " + std::to_string(entry.settings_files.size()) + " times; give it once.");
  const std::string settings_file = entry.settings_files.empty() ? "" : entry.settings_files.front();
  if (settings_file.empty() && !entry.settings_files.empty()) throw UsageError("--settings has no value.");
  if (!settings_file.empty())
    read_settings_file(settings_file, settings, entry.command.ignored_tables, " Check the name given to --settings.",
                       [&](const std::string& key) { return of_other_commands(entries, entry.command, key); });
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (!entry.texts[i].empty() && settings[i].begin_anew) settings[i].begin_anew();
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (!entry.texts[i].empty()) apply_flag(settings[i], entry.texts[i]);
  require_own_files(settings, settings_file);
  entry.command.run();
}

/// The message for an argument that the parser did not take.
/// @param command  the one that the arguments name; empty if they name none
std::string unknown_argument(const std::deque<Registered>& entries, const std::string& command,
                             const std::string& argument) {
  std::vector<std::string> flags = {"--settings", "--help"};
  std::vector<std::string> commands;
  for (const Registered& entry : entries) {
    commands.push_back(entry.command.name);
    if (!command.empty() && command != entry.command.name) continue;
    for (const Setting& setting : entry.command.settings)
      if (!setting.flag.empty()) flags.push_back(setting.flag);
  }
  const std::string see = " See hapticut " + (command.empty() ? "" : command + " ") + "--help.";
  if (argument.empty()) return "an argument is empty. Leave it out." + see;
  const bool is_flag = argument.starts_with('-');
  if (std::find(flags.begin(), flags.end(), argument) != flags.end())
    return argument + " stands before the command. Write hapticut " + (command.empty() ? "COMMAND" : command) + " " +
           argument + " ..." + see;
  if (parse_number(argument))
    return argument + " belongs to no flag. Separate the numbers of one flag by commas: 60,10,10." + see;
  if (!command.empty() && !is_flag)
    return argument + " belongs to no flag." +
           (argument.ends_with(".toml") ? " If it has settings, write --settings " + argument + "." : "") + see;
  return "there is no " + argument + "." + suggestion(argument, is_flag ? flags : commands) + see;
}

/// The first flag of a command without its value; empty if each has one.
/// @param arguments  last one first
std::string flag_without_value(const Command& command, const std::vector<std::string>& arguments) {
  const auto lacks_value = [&](const std::string& flag) {
    const auto at = std::find(arguments.begin(), arguments.end(), flag);
    return std::find(arguments.begin(), arguments.end(), flag + "=") != arguments.end() ||
           (at != arguments.end() && (at == arguments.begin() || std::prev(at)->starts_with("--")));
  };
  if (lacks_value("--settings")) return "--settings";
  for (const Setting& setting : command.settings)
    if (setting.kind != Setting::Kind::boolean && lacks_value(setting.flag)) return setting.flag;
  return "";
}

/// The message for arguments that the parser refused.
/// @param arguments  last one first
/// @param extras     those that it did not take
std::string wrong_arguments(const std::deque<Registered>& entries, const std::vector<std::string>& arguments,
                            const std::vector<std::string>& extras, const CLI::ParseError& error) {
  std::string command;
  for (const Registered& entry : entries) {
    if (!entry.app->parsed()) continue;
    command = entry.command.name;
    if (const std::string flag = flag_without_value(entry.command, arguments); !flag.empty())
      return flag + " has no value. See hapticut " + command + " --help.";
  }
  // Unknown arguments explain the error better than the missing ones that follow from them.
  if (!extras.empty()) return unknown_argument(entries, command, extras.front());
  if (!command.empty()) return std::string(error.what()) + ". See hapticut " + command + " --help.";
  return "there is no command. Choose " + joined(entries, ", ", [](const Registered& e) { return e.command.name; }) +
         ". See hapticut --help.";
}

int complain(const std::string& message, int code) {
  tell_error(message);
  return code;
}

/// Flags accept a dash instead of an underscore: --steps-csv, --voxel-mm.
void use_underscores(char* argument) {
  if (argument[0] != '-' || argument[1] != '-') return;
  for (char* c = argument + 2; *c != '\0' && *c != '='; ++c)
    if (*c == '-') *c = '_';
}

bool is_switch(const std::deque<Registered>& entries, const std::string& flag) {
  return std::any_of(entries.begin(), entries.end(), [&](const Registered& entry) {
    return std::any_of(entry.command.settings.begin(), entry.command.settings.end(), [&](const Setting& setting) {
      return setting.kind == Setting::Kind::boolean && setting.flag == flag;
    });
  });
}

/// The arguments, last first, as the parser takes them. `--thesis_mode true` becomes `--thesis_mode=true`.
std::vector<std::string> reversed_arguments(const std::deque<Registered>& entries, int argc, char** argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if ((argument == "true" || argument == "false") && !arguments.empty() && is_switch(entries, arguments.back()))
      arguments.back() += "=" + argument;
    else
      arguments.push_back(argument);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

int main_with(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) use_underscores(argv[i]);
  CLI::App app("hapticut: cutting forces for haptic rendering on sparse voxel grids", "hapticut");
  app.set_version_flag("--version", build_info().version);
  app.require_subcommand(1);
  std::deque<Registered> entries;
  for (Command& command : all_commands()) {
    Registered& entry = entries.emplace_back(Registered{std::move(command)});
    entry.app = app.add_subcommand(entry.command.name, entry.command.summary);
    register_flags(entry);
  }

  const std::vector<std::string> arguments = reversed_arguments(entries, argc, argv);
  try {
    app.parse(std::vector<std::string>(arguments));
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    return complain(wrong_arguments(entries, arguments, app.remaining(true), error), kWrongUsage);
  }

  try {
    for (const Registered& entry : entries)
      if (entry.app->parsed()) run(entries, entry);
  } catch (const AlreadyTold&) {
    return kFailed;
  } catch (const UsageError& error) {
    return complain(in_words_of_flags(error), kWrongUsage);
  } catch (const std::exception& error) {
    return complain(is_lack_of_memory(error) ? kNoMemory : in_words_of_flags(error), kFailed);
  }
  return 0;
}

}  // namespace
}  // namespace hapticut::apps

int main(int argc, char** argv) {
  hapticut::apps::prepare_for_little_memory();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit then becomes a write error
  std::signal(SIGPIPE, SIG_IGN);  // so does a reader that has gone, and the other outputs are still written
  int code = hapticut::apps::kFailed;
  try {
    code = hapticut::apps::main_with(argc, argv);
    hapticut::apps::print_on_stdout("");   // flushes what others have printed, e.g. the help
  } catch (const std::exception& error) {  // also out of memory while parsing the arguments
    std::fprintf(stderr, "hapticut: %s\n",
                 hapticut::is_lack_of_memory(error) ? hapticut::apps::kNoMemory : error.what());
    if (code == 0) code = hapticut::apps::kFailed;
  } catch (...) {
    std::fputs("hapticut: failed for an unknown reason.\n", stderr);
  }
  return code;
}
