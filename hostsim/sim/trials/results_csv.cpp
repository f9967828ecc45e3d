// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "error.hpp"
#include "support/statistics.hpp"
#include "trials/results.hpp"
#include "trials/results_columns.hpp"

namespace sim {

namespace {

// As text, each after its comma.
class FieldWriter {
  public:
    explicit FieldWriter(std::string &text) : text_(text) {
    }
    void operator()(const char *, double value) {
        text_ += field(value);
    }
    void operator()(const char *, Method value) {
        add(method_name(value));
    }
    void operator()(const char *, ocel_status_t value) {
        add(ocel_status_name(value));
    }
    void operator()(const char *, bool value) {
        add(value ? 1 : 0);
    }
    void operator()(const char *, OrEmpty votes) {
        text_ += votes.value > 0 ? fmt::format(",{}", votes.value) : ",";
    }
    template <class Value> void operator()(const char *, const Value &value) {
        add(value);
    }

  private:
    template <class Value> void add(const Value &value) {
        text_ += fmt::format(",{}", value);
    }
    std::string &text_;
};

// The other way.  cli::InputError when a field is not what its column has.
class FieldReader {
  public:
    FieldReader(const std::string &line, const std::string &place) : rest_(line), place_(place) {
    }
    void operator()(const char *name, std::string &value) {
        value = next(name);
    }
    void operator()(const char *name, double &value) {
        const std::string text = next(name);
        value = text.empty() ? kNone : number<double>(name, text);
    }
    void operator()(const char *name, Method &value) {
        const std::string text = next(name);
        const auto method = method_of(text);
        if (!method) {
            reject(name, text);
        }
        value = *method;
    }
    void operator()(const char *name, ocel_status_t &value) {
        const std::string text = next(name);
        int status = OCEL_OK;
        while (status <= OCEL_BAD_ORDER &&
               text != ocel_status_name(static_cast<ocel_status_t>(status))) {
            ++status;
        }
        if (status > OCEL_BAD_ORDER) {
            reject(name, text);
        }
        value = static_cast<ocel_status_t>(status);
    }
    void operator()(const char *name, bool &value) {
        value = number<int>(name, next(name)) != 0;
    }
    void operator()(const char *name, OrEmpty votes) {
        const std::string text = next(name);
        votes.value = text.empty() ? 0 : number<int>(name, text);
    }
    template <class Whole> void operator()(const char *name, Whole &value) {
        value = number<Whole>(name, next(name));
    }

  private:
    std::string next(const char *name) {
        if (at_ > rest_.size()) {
            reject(name, "the line's end");
        }
        const std::size_t comma = std::min(rest_.find(',', at_), rest_.size());
        const std::string text = rest_.substr(at_, comma - at_);
        at_ = comma + 1;
        return text;
    }
    template <class Number> Number number(const char *name, const std::string &text) const {
        Number value{};
        const char *const end = text.data() + text.size();
        const auto result = std::from_chars(text.data(), end, value);
        if (result.ec != std::errc() || result.ptr != end) {
            reject(name, text);
        }
        return value;
    }
    [[noreturn]] void reject(const char *name, const std::string &found) const {
        throw cli::InputError(fmt::format("{}: column {}: found {}; expected what ocellus-sim run "
                                          "writes there",
                                          place_, name, cli::quoted(found)));
    }

    const std::string &rest_;
    const std::string &place_;
    std::size_t at_ = 0;
};

std::string header() {
    std::string text;
    CsvRow row;
    visit_columns(row, [&text](const char *name, auto &&) {
        text += text.empty() ? name : "," + std::string(name);
    });
    return text;
}

std::string line_of(CsvRow &row) {
    std::string text;
    visit_columns(row, FieldWriter(text));
    return text.substr(1); // the first comma
}

// The row's trial goes on with it, or a new one begins.
void add_row(const CsvRow &row, std::vector<TrialRecord> &records) {
    const TrialRecord &trial = row.trial;
    if (records.empty() || records.back().point != trial.point ||
        records.back().trial != trial.trial) {
        records.push_back(trial);
        records.back().checks.frames = static_cast<std::uint32_t>(kSides * trial.frames);
    }
    TrialRecord &record = records.back();
    if (record.method_count < kMethodCount) {
        record.methods[record.method_count] = row.method;
    }
    ++record.method_count; // too many are counted, for who checks
}

} // namespace

std::string csv_of(const Scenario &scenario, std::uint64_t seed,
                   const std::vector<TrialRecord> &records) {
    std::string text = header() + "\n";
    CsvRow row{scenario.name, seed, scenario.target.radius, {}, {}};
    for (const TrialRecord &trial : records) {
        row.trial = trial;
        for (int i = 0; i < trial.method_count; ++i) {
            row.method = trial.methods[i];
            text += line_of(row) + "\n";
        }
    }
    return text;
}

std::vector<TrialRecord> records_of_csv(const std::string &text, const std::string &name) {
    std::istringstream lines(text);
    std::string line;
    if (!std::getline(lines, line) || line != header()) {
        throw cli::InputError(name + ":1: expected the header of this version's trials.csv");
    }
    std::vector<TrialRecord> records;
    for (int number = 2; std::getline(lines, line); ++number) {
        CsvRow row;
        const std::string place = fmt::format("{}:{}", name, number);
        visit_columns(row, FieldReader(line, place));
        add_row(row, records);
    }
    return records;
}

nlohmann::ordered_json write_results(const Scenario &scenario, std::uint64_t seed,
                                     const std::vector<TrialRecord> &records,
                                     const std::string &out) {
    const std::string path = out + "/trials.csv";
    const std::string csv = csv_of(scenario, seed, records);
    const nlohmann::ordered_json summary = summary_of(scenario, seed, records_of_csv(csv, path));
    write_text(path, csv);
    write_text(out + "/summary.json", summary.dump(1) + "\n");
    return summary;
}

void make_folder(const std::string &path, const char *option) {
    std::error_code mistake;
    std::filesystem::create_directories(path, mistake);
    if (!std::filesystem::is_directory(path)) {
        throw cli::InputError(std::string(option) + " " + path +
                              ": cannot be made; expected a folder's name");
    }
}

void write_text(const std::string &path, const std::string &text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) {
        throw cli::InputError(path + ": cannot be written; expected a folder with room in it");
    }
}

} // namespace sim
