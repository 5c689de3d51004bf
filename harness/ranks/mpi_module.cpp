/// Message passing by MPI. A module of its own: see message_passing.hpp.

#include <mpi.h>
#include <sched.h>

#include <cstdlib>
#include <list>
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

bool has_come(int* from, int* tag, std::size_t* count) {
  forget_what_has_arrived();
  int is_there = 0, bytes = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) return false;
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  *from = status.MPI_SOURCE;
  *tag = status.MPI_TAG;
  *count = static_cast<std::size_t>(bytes);
  return true;
}

void receive(int from, int tag, char* bytes, std::size_t count) {
  MPI_Recv(bytes, static_cast<int>(count), MPI_BYTE, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

void finish() {
  for (Sent& message : sent()) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  sent().clear();
  MPI_Finalize();
}

void abort_all(int code) { MPI_Abort(MPI_COMM_WORLD, code); }

/// Those that this rank is bound to, and those of all ranks of its machine.
struct Cores {
  cpu_set_t own, all;
};

Cores& cores() {
  static Cores both;
  return both;
}

/// Where the system refuses, the thread stays where it is.
void spread(bool to_all) { sched_setaffinity(0, sizeof(cpu_set_t), to_all ? &cores().all : &cores().own); }

void look_around(gcs::MessagePassing& passing) {
  MPI_Comm here;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &passing.on_this_machine);
  CPU_ZERO(&cores().own);
  sched_getaffinity(0, sizeof(cpu_set_t), &cores().own);
  MPI_Allreduce(&cores().own, &cores().all, sizeof(cpu_set_t), MPI_BYTE, MPI_BOR, here);
  MPI_Comm_free(&here);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const gcs::MessagePassing* gcsbench_start_message_passing() {
  static gcs::MessagePassing passing;
  // Between processes of one machine Open MPI sends more than 4 KiB in several parts, each of which waits until both sides
  // look; a few paths have ten. The user's own setting stays.
  setenv("OMPI_MCA_btl_vader_eager_limit", "32768", 0);
  int level = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS) return nullptr;
  MPI_Comm_rank(MPI_COMM_WORLD, &passing.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &passing.size);
  look_around(passing);
  passing.send = send;
  passing.has_come = has_come;
  passing.receive = receive;
  passing.spread = spread;
  passing.finish = finish;
  passing.abort = abort_all;
  return &passing;
}
