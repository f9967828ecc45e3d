// SPDX-License-Identifier: MIT
//
// Processes, not threads: the renderer draws in one thread, and a trial shares
// nothing.  Each process takes every jobs-th trial and sends its records through
// one pipe; a record is smaller than what a pipe takes in one piece.
#include "runner.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>

#include "picture.hpp"
#include "progress.hpp"

namespace sim {

namespace {

static_assert(std::is_trivially_copyable_v<TrialRecord>);
static_assert(sizeof(TrialRecord) <= PIPE_BUF, "two processes' records would mix");

TrialKey key_of(std::size_t index, const RunOptions &options) {
    const auto trials = static_cast<std::size_t>(options.trials);
    return {index / trials, static_cast<int>(index % trials), options.seed};
}

std::size_t total_trials(const Scenario &scenario, const RunOptions &options) {
    return scenario.points.size() * static_cast<std::size_t>(options.trials);
}

TrialRecord run_one(const Scenario &scenario, const RunOptions &options, const TrialKey &key,
                    Studio &studio) {
    if (options.picture_dir.empty() || key.trial != 0) {
        return studio.run(key, nullptr);
    }
    TrialPictures pictures;
    const TrialRecord record = studio.run(key, &pictures);
    cli::write_png(fmt::format("{}/{}_p{:02}.png", options.picture_dir, scenario.name, key.point),
                   annotated_pair(scenario, record, pictures));
    return record;
}

void send(int pipe, const TrialRecord &record) {
    if (::write(pipe, &record, sizeof record) != static_cast<ssize_t>(sizeof record)) {
        throw std::runtime_error("a result cannot be sent to the parent process");
    }
}

// The life of a child process; its exit code.
int work(const Scenario &scenario, const RunOptions &options, int job, int pipe) {
    try {
        std::optional<Recording> recording;
        if (!options.record_dir.empty()) {
            recording.emplace(options.record_dir, scenario);
        }
        Studio studio(scenario, recording ? &*recording : nullptr);
        const std::size_t total = total_trials(scenario, options);
        for (std::size_t i = static_cast<std::size_t>(job); i < total;
             i += static_cast<std::size_t>(options.jobs)) {
            send(pipe, run_one(scenario, options, key_of(i, options), studio));
        }
    } catch (const std::exception &error) {
        std::fprintf(stderr, "ocellus-sim: error: %s\n", error.what());
        return 1;
    }
    return 0;
}

std::vector<pid_t> start_workers(const Scenario &scenario, const RunOptions &options,
                                 const int pipe[2]) {
    std::vector<pid_t> workers;
    for (int job = 0; job < options.jobs; ++job) {
        const pid_t pid = ::fork();
        if (pid < 0) {
            throw std::runtime_error("no process can be started for --jobs");
        }
        if (pid == 0) {
            ::close(pipe[0]);
            ::_exit(work(scenario, options, job, pipe[1]));
        }
        workers.push_back(pid);
    }
    return workers;
}

// False at the end.  A record may come in pieces when the reader is ahead.
bool receive(int pipe, TrialRecord &record) {
    char *const bytes = reinterpret_cast<char *>(&record);
    std::size_t got = 0;
    while (got < sizeof record) {
        const ssize_t n = ::read(pipe, bytes + got, sizeof record - got);
        if (n == 0) {
            return false;
        }
        if (n > 0) {
            got += static_cast<std::size_t>(n);
        } else if (errno != EINTR) {
            throw std::runtime_error("a result cannot be read from a process");
        }
    }
    return true;
}

void await_workers(const std::vector<pid_t> &workers) {
    bool good = true;
    for (const pid_t pid : workers) {
        int status = 0;
        good = ::waitpid(pid, &status, 0) == pid && WIFEXITED(status) && WEXITSTATUS(status) == 0 &&
               good;
    }
    if (!good) {
        throw std::runtime_error("a worker process failed, the run is not complete");
    }
}

bool comes_before(const TrialRecord &a, const TrialRecord &b) {
    return a.point != b.point ? a.point < b.point : a.trial < b.trial;
}

} // namespace

std::vector<TrialRecord> run_trials(const Scenario &scenario, const RunOptions &options) {
    const std::size_t total = total_trials(scenario, options);
    int pipe[2];
    if (::pipe(pipe) != 0) {
        throw std::runtime_error("no pipe for the workers' results");
    }
    std::fflush(nullptr); // or a child would write it again
    const std::vector<pid_t> workers = start_workers(scenario, options, pipe);
    ::close(pipe[1]);
    Progress progress(scenario.name, total);
    std::vector<TrialRecord> records;
    TrialRecord record;
    while (receive(pipe[0], record)) {
        records.push_back(record);
        progress.advance();
    }
    ::close(pipe[0]);
    await_workers(workers);
    std::sort(records.begin(), records.end(), comes_before);
    return records;
}

} // namespace sim
