// SPDX-License-Identifier: MIT
//
// Work spread over processes: not threads, as the renderer draws in one thread and
// what is worked on shares nothing.
#ifndef OCELLUS_SIM_PROCESSES_HPP
#define OCELLUS_SIM_PROCESSES_HPP

#include <climits>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace sim {

struct Batch {
    std::string name; // for the progress
    std::size_t items;
    std::string unit = "trials"; // what the items are, in the plural
    int jobs = 1;                // processes
};

// Item number in, that many bytes of its result out.
using ByteWorker = std::function<void(std::size_t item, void *result)>;

// Each process starts a worker of its own and gives it every jobs-th item; `done` gets
// the results here as they come.  std::runtime_error when a process fails, which has
// then said why on stderr.
void in_processes(const Batch &batch, std::size_t result_bytes,
                  const std::function<ByteWorker()> &start,
                  const std::function<void(std::size_t item, const void *result)> &done);

// The results in the order of the items, whatever batch.jobs is.  `start` returns what
// makes a result of an item.
template <typename Result>
std::vector<Result> results_of(const Batch &batch,
                               const std::function<std::function<Result(std::size_t)>()> &start) {
    static_assert(std::is_trivially_copyable_v<Result>, "it goes through a pipe");
    static_assert(sizeof(std::size_t) + sizeof(Result) <= PIPE_BUF,
                  "two processes' results would mix");
    std::vector<Result> results(batch.items);
    in_processes(
        batch, sizeof(Result),
        [&start]() -> ByteWorker {
            return [worker = start()](std::size_t item, void *result) {
                const Result made = worker(item);
                std::memcpy(result, &made, sizeof made);
            };
        },
        [&results](std::size_t item, const void *result) {
            std::memcpy(&results[item], result, sizeof(Result));
        });
    return results;
}

} // namespace sim

#endif
