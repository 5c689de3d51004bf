#pragma once
/// What the module that speaks MPI gives the program: plain C, so that nothing else has to fit.

#include <cstddef>

namespace gcs {

/// Of a program that was started as several ranks. All by one thread.
struct MessagePassing {
  int rank = 0;
  int size = 1;
  int on_this_machine = 1;  ///< ranks
  /// Returns at once; the bytes are copied.
  void (*send)(int to, int tag, const char* bytes, std::size_t count) = nullptr;
  /// Whether a message has come, and what it is.
  bool (*has_come)(int* from, int* tag, std::size_t* count) = nullptr;
  /// The message that has_come() told of.
  void (*receive)(int from, int tag, char* bytes, std::size_t count) = nullptr;
  /// Binds the thread, and those that it starts from now on, to this rank's cores, or to those of all ranks of its machine.
  void (*spread)(bool to_all) = nullptr;
  /// The last call of every rank. Waits for what is sent.
  void (*finish)() = nullptr;
  /// Ends all ranks with this exit code.
  void (*abort)(int code) = nullptr;
};

/// Of the module: start_message_passing_name. The structure lives as long as the module.
using StartMessagePassing = const MessagePassing* (*)();
inline constexpr const char* start_message_passing_name = "gcsbench_start_message_passing";

}  // namespace gcs
