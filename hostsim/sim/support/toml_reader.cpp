// SPDX-License-Identifier: MIT
#include "support/toml_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

#include "error.hpp"

namespace sim {

namespace {

std::string found(const toml::node &node) {
    std::ostringstream text;
    node.visit([&text](const auto &value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (toml::is_table<Value>) {
            text << "a table";
        } else {
            text << value;
        }
    });
    return text.str();
}

std::string joined(const std::vector<std::string> &words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char *const before = i == 0 ? "" : (i + 1 == words.size() ? " or " : ", ");
        list += before + words[i];
    }
    return list;
}

std::string range(double low, double high, const char *unit) {
    return fmt::format("a number {} .. {}{}{}", low, high, *unit == '\0' ? "" : " ", unit);
}

} // namespace

TomlReader::TomlReader(const toml::table &table, const std::string &file, const std::string &name)
    : table_(table), file_(file), name_(name) {
}

void TomlReader::reject_at(const toml::source_region &place, const std::string &key,
                           const std::string &what) const {
    throw cli::InputError(fmt::format("{}:{}:{}: {}{}: {}", file_, place.begin.line,
                                      place.begin.column, name_.empty() ? "" : "[" + name_ + "] ",
                                      key, what));
}

void TomlReader::reject(const std::string &key, const std::string &found_and_expected) const {
    reject_at(table_.get(key)->source(), key, found_and_expected);
}

const toml::node &TomlReader::node(const std::string &key, const std::string &expected) {
    asked_.insert(key);
    const toml::node *const value = table_.get(key);
    if (value == nullptr) {
        reject_at(table_.source(), key, "is missing; expected " + expected);
    }
    return *value;
}

bool TomlReader::has(const std::string &key) const {
    return table_.contains(key);
}

TomlReader TomlReader::table(const std::string &key) {
    const toml::node &value = node(key, "a table [" + key + "]");
    if (!value.is_table()) {
        reject_at(value.source(), key, "found " + found(value) + "; expected a table");
    }
    return {*value.as_table(), file_, key};
}

std::vector<TomlReader> TomlReader::tables(const std::string &key) {
    std::vector<TomlReader> readers;
    asked_.insert(key);
    if (const toml::node *const value = table_.get(key)) {
        const toml::array *const elements = value->as_array();
        if (elements == nullptr || !elements->is_homogeneous<toml::table>()) {
            reject_at(value->source(), key,
                      "found " + found(*value) + "; expected tables [[" + key + "]]");
        }
        for (const toml::node &element : *elements) {
            readers.push_back(TomlReader(*element.as_table(), file_, key));
        }
    }
    return readers;
}

std::string TomlReader::text(const std::string &key, const char *expected) {
    const toml::node &value = node(key, expected);
    const auto text = value.value<std::string>();
    if (!value.is_string() || !text) {
        reject_at(value.source(), key, "found " + found(value) + "; expected " + expected);
    }
    return *text;
}

double TomlReader::number_of(const toml::node &node, const std::string &key, double low,
                             double high, const char *unit) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !(*value >= low && *value <= high)) {
        reject_at(node.source(), key,
                  "found " + found(node) + "; expected " + range(low, high, unit));
    }
    return *value;
}

double TomlReader::number(const std::string &key, double low, double high, const char *unit) {
    return number_of(node(key, range(low, high, unit)), key, low, high, unit);
}

int TomlReader::integer(const std::string &key, int low, int high, const char *unit) {
    const toml::node &value = node(key, "a whole number");
    if (!value.is_integer()) {
        reject_at(value.source(), key, "found " + found(value) + "; expected a whole number");
    }
    return static_cast<int>(number_of(value, key, low, high, unit));
}

int TomlReader::choice_of(const toml::node &node, const std::string &key,
                          const std::vector<std::string> &words) const {
    const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
    for (std::size_t i = 0; value && i < words.size(); ++i) {
        if (*value == words[i]) {
            return static_cast<int>(i);
        }
    }
    reject_at(node.source(), key, "found " + found(node) + "; expected " + joined(words));
}

int TomlReader::choice(const std::string &key, const std::vector<std::string> &words) {
    return choice_of(node(key, joined(words)), key, words);
}

const toml::array &TomlReader::array(const std::string &key, const std::string &expected) {
    const toml::node &value = node(key, expected);
    if (!value.is_array() || value.as_array()->empty()) {
        reject_at(value.source(), key, "found " + found(value) + "; expected " + expected);
    }
    return *value.as_array();
}

std::vector<double> TomlReader::numbers(const std::string &key, double low, double high,
                                        const char *unit) {
    std::vector<double> values;
    for (const toml::node &element : array(key, "a list [ ... ] of numbers")) {
        values.push_back(number_of(element, key, low, high, unit));
    }
    return values;
}

std::vector<int> TomlReader::choices(const std::string &key,
                                     const std::vector<std::string> &words) {
    std::vector<int> values;
    for (const toml::node &element : array(key, "a list [ ... ] of " + joined(words))) {
        values.push_back(choice_of(element, key, words));
    }
    return values;
}

void TomlReader::expect_only(const std::vector<std::string> &keys) const {
    for (const auto &[key, value] : table_) {
        if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
            reject_at(key.source(), std::string(key.str()),
                      "is no key here; expected " + joined(keys));
        }
    }
}

void TomlReader::finish() const {
    for (const auto &[key, value] : table_) {
        if (asked_.count(std::string(key.str())) == 0) {
            reject_at(key.source(), std::string(key.str()),
                      "has no meaning with what the others say; expected it to be left out");
        }
    }
}

} // namespace sim
