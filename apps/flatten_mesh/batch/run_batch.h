// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_BATCH_H
#define FLATTEN_MESH_RUN_BATCH_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Failure.h"
#include "flatten_mesh/Unfinished_file.h"
#include "flatten_mesh/batch/Child_process.h"
#include "flatten_mesh/batch/Child_processes.h"
#include "flatten_mesh/batch/final_report.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <poll.h>
#include <sys/wait.h>

namespace flatten_mesh {

namespace internal {

// Of a run that has ended
struct Result_of_run
{
  Exit_status status = SUCCESS;
  std::optional<Failure> failure; // unless the run has told its result itself
  std::string output, errors;     // what it printed, unless that was printed at once
};

inline Failure crash(const Command_line& command, const std::string& reason)
{
  return {RUN_CRASHED, "CRASHED", command.title + ": CRASHED: " + reason};
}

inline Failure not_enough_memory(const Command_line& command)
{
  return {OUT_OF_MEMORY, "OUT_OF_MEMORY",
          command.title + ": OUT_OF_MEMORY: not enough memory: " + command.batch.memory +
              " do not suffice; --memory sets that bound"};
}

// The cause is known to the process that ended, if to anybody.
inline std::optional<Failure> failure_of_run(const Command_line& command, const Child_process& process,
                                             const int result)
{
  if(!process.text(Child_process::EXIT_STATUS).empty()) {
    return std::nullopt;
  }
  if(process.exceeded() == Child_process::MEMORY) {
    return not_enough_memory(command);
  }
  if(process.exceeded() == Child_process::TIME) {
    return Failure{TIMED_OUT, "TIMED_OUT",
                   command.title + ": TIMED_OUT: not done after " +
                       format_number("%g s", command.batch.timeout) + "; --timeout sets that bound"};
  }
  if(!WIFSIGNALED(result)) {
    return crash(command, "ended with status " + std::to_string(WEXITSTATUS(result)) + " before it was done");
  }
  const int signal = WTERMSIG(result);
  return crash(command, "ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")" +
                            (signal == SIGKILL ? ": the system ends processes where memory runs out" : ""));
}

inline Result_of_run result_of(const Command_line& command, Child_process& process)
{
  const int result = process.wait();
  if(WIFSIGNALED(result) && WTERMSIG(result) == SIGPIPE) { // nobody reads what is printed
    std::raise(SIGPIPE);
  }
  Result_of_run run;
  run.failure = failure_of_run(command, process, result);
  run.status = run.failure ? run.failure->exit_status
                           : static_cast<Exit_status>(process.text(Child_process::EXIT_STATUS).front());
  run.output = process.text(Child_process::OUTPUT);
  run.errors = process.text(Child_process::ERRORS);
  return run;
}

inline Command_line with_share_of_threads(Command_line command)
{
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  if(command.batch.jobs > 1 && command.options.threads == 0) {
    command.options.threads = (std::max)(1, processors / command.batch.jobs);
  }
  return command;
}

// Runs in processes of their own, several at once.
template <class Run>
class Batch
{
public:
  // `run` is called for each input.
  Batch(const Command_line& command, const Run& run)
      : m_whole(with_share_of_threads(command)), m_commands(m_whole), m_run(run),
        m_number(command.atlas.is_shared ? 1 : m_commands.size())
  {}

  // The first exit status that is not 0, by the order of the inputs, and not of time.
  Exit_status run()
  {
    Child_processes::end_when_interrupted();
    while(m_told < m_number) {
      while(m_next < m_number && m_running.size() < static_cast<std::size_t>(m_whole.batch.jobs)) {
        start(m_next++);
      }
      if(!m_running.empty()) {
        wait();
      }
      collect();
      tell();
    }
    Unfinished_files::remove_when_interrupted();
    for(const std::filesystem::path& folder : m_folders) {
      Unfinished_file::remove_abandoned(folder.empty() ? "." : folder);
    }
    if(m_whole.batch.resumes && !m_whole.quiet) {
      std::cerr << "flatten_mesh: " << m_skipped << " of " << count_text(m_number, "input")
                << " skipped, whose reports are final" << std::endl;
    }
    return m_status;
  }

private:
  Command_line command_of(const std::size_t number) const
  {
    return m_whole.atlas.is_shared ? m_whole : m_commands[number];
  }

  void start(const std::size_t number)
  {
    const Command_line command = command_of(number);
    for(const Output_option& option : output_options()) {
      m_folders.insert(std::filesystem::path(command.*option.file).parent_path());
    }
    if(const auto status = m_whole.batch.resumes ? final_status(command) : std::nullopt) {
      m_results[number].status = *status;
      ++m_skipped;
      return;
    }
    const bool takes_output = m_whole.batch.jobs > 1 && m_number > 1;
    m_running.emplace(number, std::make_unique<Child_process>(takes_output, deadline(), [&] {
                        m_running.clear(); // closes their pipes
                        Unfinished_file::leave_abandoned();
                        return m_run(command);
                      }));
  }

  Child_process::Clock::time_point deadline() const
  {
    using Clock = Child_process::Clock;
    const double longest = 1e8; // three years
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>((std::min)(m_whole.batch.timeout, longest)));
  }

  double megabytes() const
  {
    return m_whole.batch.memory_bytes == 0 ? std::numeric_limits<double>::infinity()
                                           : m_whole.batch.memory_bytes / (1024. * 1024);
  }

  // For output of a process, the end of one, a deadline, or a look at the memory of all
  void wait()
  {
    using Clock = Child_process::Clock;
    std::vector<pollfd> files;
    Clock::time_point next =
        Clock::now() + (m_whole.batch.memory_bytes == 0 ? Clock::duration(std::chrono::hours(1))
                                                        : Clock::duration(std::chrono::milliseconds(5)));
    for(const auto& [number, process] : m_running) {
      process->append_to(files);
      next = (std::min)(next, process->deadline());
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now()).count();
    if(::poll(files.data(), files.size(), static_cast<int>((std::max)(0L, static_cast<long>(left) + 1))) >
       0) {
      for(const pollfd& file : files) {
        if(file.revents != 0) {
          for(const auto& [number, process] : m_running) {
            process->read(file.fd);
          }
        }
      }
    }
  }

  void collect()
  {
    for(auto i = m_running.begin(); i != m_running.end();) {
      if(i->second->has_ended()) {
        m_results.emplace(i->first, result_of(command_of(i->first), *i->second));
        i = m_running.erase(i);
      } else {
        i->second->keep_bounds(megabytes());
        ++i;
      }
    }
  }

  // What all runs printed that have ended, up to the first that has not
  void tell()
  {
    for(auto i = m_results.find(m_told); i != m_results.end(); i = m_results.find(m_told)) {
      const Result_of_run& result = i->second;
      std::cout << result.output << std::flush;
      std::cerr << result.errors << std::flush;
      if(result.failure) {
        tell_failure(command_of(m_told), *result.failure);
      }
      m_status = m_status == SUCCESS ? result.status : m_status;
      m_results.erase(i);
      ++m_told;
    }
  }

  Command_line m_whole;
  Commands_of_models m_commands;
  const Run& m_run;
  std::size_t m_number;
  std::size_t m_next = 0, m_told = 0, m_skipped = 0;
  std::map<std::size_t, std::unique_ptr<Child_process>> m_running;
  std::map<std::size_t, Result_of_run> m_results;
  std::set<std::filesystem::path> m_folders; // of all outputs
  Exit_status m_status = SUCCESS;
};

} // namespace internal

// Whether each input has a process of its own: so that one that crashes leaves the others alone, or can be ended.
inline bool needs_processes(const Command_line& command)
{
  return (command.input.empty() && !command.atlas.is_shared) || command.batch.has_bounds() ||
         command.batch.resumes;
}

// Calls `run` for each input in a process of its own.
template <class Run>
Exit_status run_batch(const Command_line& command, const Run& run)
{
  return internal::Batch<Run>(command, run).run();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_BATCH_H
