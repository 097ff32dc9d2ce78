// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hapticut/core/on_one_line.hpp"

/// @file
/// Sentences for users of C++, Python, C and the program. They name the same field differently, so a sentence keeps its
/// names apart from its text:
///
///     throw Error("DeltaFilter::epsilon"_name + " = 3; must be at most " + "DeltaFilter::delta"_name + ".");
///
/// Each front end has a table of its words for names; tests/meta/messages.py checks that the tables are complete.
namespace hapticut {

/// The C++ name of a field, a function, a type or a value: `GuardOptions::period`; or the key of a setting:
/// `tool.radius_mm`. Refers to characters of the caller.
class Name {
 public:
  constexpr explicit Name(std::string_view text) : text_(text), colons_(text.rfind("::")) {}

  [[nodiscard]] constexpr std::string_view text() const { return text_; }  ///< as in C++
  [[nodiscard]] constexpr std::string_view scope() const {                 ///< "GuardOptions"; "" for a free name
    return colons_ == std::string_view::npos ? std::string_view() : text_.substr(0, colons_);
  }
  [[nodiscard]] constexpr std::string_view member() const {  ///< "period"
    return colons_ == std::string_view::npos ? text_ : text_.substr(colons_ + 2);
  }

 private:
  std::string_view text_;
  std::size_t colons_;
};

[[nodiscard]] constexpr Name operator""_name(const char* text, std::size_t length) {
  return Name(std::string_view(text, length));
}

/// Text with names. Grows by `+`, like std::string.
class Sentence {
 public:
  // NOLINTBEGIN(google-explicit-constructor): texts and names become sentences as literals become std::string
  Sentence(const char* text) : Sentence(std::string(text)) {}
  Sentence(std::string text) : parts_{{Part::Kind::text, std::move(text)}} {}
  Sentence(Name name) : parts_{{Part::Kind::name, std::string(name.text())}} {}
  // NOLINTEND(google-explicit-constructor)

  /// A part of a sentence that a front end leaves out if it has no word for one of its names: advice about a field
  /// that its users cannot set.
  [[nodiscard]] static Sentence clause(Sentence sentence) {
    sentence.parts_.insert(sentence.parts_.begin(), {Part::Kind::clause, ""});
    sentence.parts_.push_back({Part::Kind::end, ""});
    return sentence;
  }

  Sentence& operator+=(const Sentence& other) {
    parts_.insert(parts_.end(), other.parts_.begin(), other.parts_.end());
    return *this;
  }

  /// The sentence on one line, in the words of a front end.
  /// @param word_for  a function from a Name to std::optional<std::string>; nothing: the front end has no word for it.
  ///                  Outside a clause the member's name stands then.
  template <class WordFor>
  [[nodiscard]] std::string written(const WordFor& word_for) const {
    std::string text;
    std::size_t begin = 0;  // where the clause begins
    bool left_out = false;
    for (const Part& part : parts_) {
      if (part.kind == Part::Kind::text) text += part.text;
      if (part.kind == Part::Kind::name) {
        const std::optional<std::string> word = word_for(Name(part.text));
        text += word ? *word : std::string(Name(part.text).member());
        left_out = left_out || !word;
      }
      if (part.kind == Part::Kind::clause) begin = text.size();
      if (part.kind == Part::Kind::end && left_out) text.resize(begin);
      if (part.kind == Part::Kind::clause || part.kind == Part::Kind::end) left_out = false;
    }
    return on_one_line(std::move(text));
  }

  /// With the names of C++.
  [[nodiscard]] std::string in_cpp() const {
    return written([](const Name& name) { return std::optional(std::string(name.text())); });
  }

 private:
  struct Part {
    enum class Kind { text, name, clause, end } kind;
    std::string text;
  };
  std::vector<Part> parts_;
};

[[nodiscard]] inline Sentence operator+(Sentence first, const Sentence& then) { return std::move(first += then); }

/// What a check is about: "SphereHead::radius [m]" is a name with its unit, "voxel size [m]" only words.
class Subject {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): each check has a literal
  constexpr Subject(const char* text) : name_(""), words_(text) {
    constexpr std::string_view kOfNames = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_:.";
    std::size_t end = words_.find_first_not_of(kOfNames);
    if (end == std::string_view::npos) end = words_.size();
    while (end > 0 && (words_[end - 1] == ':' || words_[end - 1] == '.')) --end;
    if (Name(words_.substr(0, end)).scope().empty()) return;
    name_ = Name(words_.substr(0, end));
    words_.remove_prefix(end);
  }
  /// @param words  after the name, e.g. its unit: " [m]"
  Subject(Name name, std::string_view words) : name_(name), words_(words) {}

  // NOLINTNEXTLINE(google-explicit-constructor): sentences begin with it
  operator Sentence() const { return Sentence(name_) + std::string(words_); }

 private:
  Name name_;
  std::string_view words_;
};

}  // namespace hapticut
