// SPDX-License-Identifier: MIT
//
// All processes write to one pipe; an item's number and result are less than what a
// pipe takes in one piece.
#include "support/processes.hpp"

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "support/progress.hpp"

namespace sim {

namespace {

// The number of an item and, after it, its result.
class Message {
  public:
    explicit Message(std::size_t result_bytes) : bytes_(sizeof(std::size_t) + result_bytes) {
    }

    std::size_t item() const {
        std::size_t item;
        std::memcpy(&item, bytes_.data(), sizeof item);
        return item;
    }
    void set_item(std::size_t item) {
        std::memcpy(bytes_.data(), &item, sizeof item);
    }
    char *result() {
        return bytes_.data() + sizeof(std::size_t);
    }

    void send(int pipe) const {
        if (::write(pipe, bytes_.data(), bytes_.size()) != static_cast<ssize_t>(bytes_.size())) {
            throw std::runtime_error("a result cannot be sent to the parent process");
        }
    }

    // False at the end.  It may come in pieces when the reader is ahead.
    bool receive(int pipe) {
        std::size_t got = 0;
        while (got < bytes_.size()) {
            const ssize_t n = ::read(pipe, bytes_.data() + got, bytes_.size() - got);
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

  private:
    std::vector<char> bytes_;
};

// The life of a child process; its exit code.
int work(const Batch &batch, std::size_t result_bytes, const std::function<ByteWorker()> &start,
         int job, int pipe) {
    try {
        const ByteWorker worker = start();
        Message message(result_bytes);
        for (auto item = static_cast<std::size_t>(job); item < batch.items;
             item += static_cast<std::size_t>(batch.jobs)) {
            message.set_item(item);
            worker(item, message.result());
            message.send(pipe);
        }
    } catch (const std::exception &error) {
        std::fprintf(stderr, "ocellus-sim: error: %s\n", error.what());
        return 1;
    }
    return 0;
}

std::vector<pid_t> start_processes(const Batch &batch, std::size_t result_bytes,
                                   const std::function<ByteWorker()> &start, const int pipe[2]) {
    std::vector<pid_t> processes;
    for (int job = 0; job < batch.jobs; ++job) {
        const pid_t pid = ::fork();
        if (pid < 0) {
            throw std::runtime_error("no process can be started for --jobs");
        }
        if (pid == 0) {
            ::close(pipe[0]);
            ::_exit(work(batch, result_bytes, start, job, pipe[1]));
        }
        processes.push_back(pid);
    }
    return processes;
}

void await(const std::vector<pid_t> &processes) {
    bool good = true;
    for (const pid_t pid : processes) {
        int status = 0;
        good = ::waitpid(pid, &status, 0) == pid && WIFEXITED(status) && WEXITSTATUS(status) == 0 &&
               good;
    }
    if (!good) {
        throw std::runtime_error("a worker process failed, the run is not complete");
    }
}

} // namespace

void in_processes(const Batch &batch, std::size_t result_bytes,
                  const std::function<ByteWorker()> &start,
                  const std::function<void(std::size_t item, const void *result)> &done) {
    int pipe[2];
    if (::pipe(pipe) != 0) {
        throw std::runtime_error("no pipe for the workers' results");
    }
    std::fflush(nullptr); // or a child would write it again
    const std::vector<pid_t> processes = start_processes(batch, result_bytes, start, pipe);
    ::close(pipe[1]);
    Progress progress(batch.name, batch.items, batch.unit);
    Message message(result_bytes);
    while (message.receive(pipe[0])) {
        done(message.item(), message.result());
        progress.advance();
    }
    ::close(pipe[0]);
    await(processes);
}

} // namespace sim
