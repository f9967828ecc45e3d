// SPDX-License-Identifier: MIT
//
// Reads a TOML table key by key, and accepts nothing that was not asked for.
#ifndef OCELLUS_SIM_TOML_READER_HPP
#define OCELLUS_SIM_TOML_READER_HPP

#include <set>
#include <string>
#include <toml++/toml.h>
#include <vector>

namespace sim {

// All functions throw cli::InputError: `FILE:LINE:COLUMN: ` and what is wrong.
class TomlReader {
  public:
    // `table` and `file` must outlive it; `name` is "" for the file itself.
    TomlReader(const toml::table &table, const std::string &file, const std::string &name);

    // Whether a key that may be left out stands there.
    bool has(const std::string &key) const;

    TomlReader table(const std::string &key);
    // The tables [[key]] of which there may be any number, none included.
    std::vector<TomlReader> tables(const std::string &key);
    std::string text(const std::string &key, const char *expected);
    double number(const std::string &key, double low, double high, const char *unit);
    int integer(const std::string &key, int low, int high, const char *unit);
    // The place in `words` of the word that stands there.
    int choice(const std::string &key, const std::vector<std::string> &words);
    std::vector<double> numbers(const std::string &key, double low, double high, const char *unit);
    std::vector<int> choices(const std::string &key, const std::vector<std::string> &words);

    // No key is there but these: to be called first, as a misspelt key is also
    // one that is missing.
    void expect_only(const std::vector<std::string> &keys) const;

    // Every key has been asked for: what is left is of no use with the others.
    void finish() const;

    // Says that the value of `key` is wrong.
    [[noreturn]] void reject(const std::string &key, const std::string &found_and_expected) const;

  private:
    const toml::node &node(const std::string &key, const std::string &expected);
    [[noreturn]] void reject_at(const toml::source_region &place, const std::string &key,
                                const std::string &what) const;
    double number_of(const toml::node &node, const std::string &key, double low, double high,
                     const char *unit) const;
    int choice_of(const toml::node &node, const std::string &key,
                  const std::vector<std::string> &words) const;
    const toml::array &array(const std::string &key, const std::string &expected);

    const toml::table &table_;
    const std::string &file_;
    std::string name_;
    std::set<std::string> asked_;
};

} // namespace sim

#endif
