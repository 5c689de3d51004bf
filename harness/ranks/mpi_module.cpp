/// Message passing by MPI. A module of its own: see message_passing.hpp.

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <list>
#include <set>
#include <string>
#include <utility>

#include "harness/ranks/message_passing.hpp"

namespace {

struct Sent {
  std::string bytes;
  MPI_Request request;
};

std::list<Sent>& sent() {
  static std::list<Sent> messages;
  return messages;
}

void forget_what_has_arrived() {
  sent().remove_if([](Sent& message) {
    int is_done = 0;
    MPI_Test(&message.request, &is_done, MPI_STATUS_IGNORE);
    return is_done != 0;
  });
}

void send(int to, int tag, const char* bytes, std::size_t count) {
  forget_what_has_arrived();
  Sent& message = sent().emplace_back(Sent{std::string(bytes, count), MPI_REQUEST_NULL});
  MPI_Isend(message.bytes.data(), static_cast<int>(count), MPI_BYTE, to, tag, MPI_COMM_WORLD,
            &message.request);
}

/// A message on its way. One that is not small takes several looks of both sides, and whoever computes does not look.
struct Coming {
  int from = 0;
  int tag = 0;
  std::string bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

std::list<Coming>& coming() {
  static std::list<Coming> messages;
  return messages;
}

void begin_to_receive() {
  constexpr std::size_t most = 256;  // so that thousands of ranks do not fill the memory of the first
  while (coming().size() < most) {
    int is_there = 0, bytes = 0;
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &message, &status);
    if (is_there == 0) return;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    Coming& one = coming().emplace_back(
        Coming{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(bytes), '\0')});
    MPI_Imrecv(one.bytes.data(), bytes, MPI_BYTE, &message, &one.request);
  }
}

/// Those of one rank come in the order in which they were sent.
std::list<Coming>::iterator first_that_is_here() {
  std::set<int> late;
  for (auto message = coming().begin(); message != coming().end(); ++message) {
    int is_done = 0;
    MPI_Test(&message->request, &is_done, MPI_STATUS_IGNORE);
    if (is_done != 0 && !late.contains(message->from)) return message;
    late.insert(message->from);
  }
  return coming().end();
}

bool has_come(int* from, int* tag, std::size_t* count) {
  forget_what_has_arrived();
  begin_to_receive();
  const auto here = first_that_is_here();
  if (here == coming().end()) return false;
  coming().splice(coming().begin(), coming(), here);
  *from = here->from;
  *tag = here->tag;
  *count = here->bytes.size();
  return true;
}

void receive(char* bytes) {
  std::ranges::copy(coming().front().bytes, bytes);
  coming().pop_front();
}

void finish() {
  for (Sent& message : sent()) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  sent().clear();
  MPI_Finalize();
}

void abort_all(int code) { MPI_Abort(MPI_COMM_WORLD, code); }

int ranks_on_this_machine() {
  MPI_Comm here;
  int size = 1;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &size);
  MPI_Comm_free(&here);
  return size;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const gcs::MessagePassing* gcsbench_start_message_passing() {
  static gcs::MessagePassing passing;
  int level = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS) return nullptr;
  MPI_Comm_rank(MPI_COMM_WORLD, &passing.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &passing.size);
  passing.on_this_machine = ranks_on_this_machine();
  passing.send = send;
  passing.has_come = has_come;
  passing.receive = receive;
  passing.finish = finish;
  passing.abort = abort_all;
  return &passing;
}
