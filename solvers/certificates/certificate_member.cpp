#include "solvers/certificates/certificate_member.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

#include "solvers/running/message_bytes.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

using Point = std::vector<std::complex<double>>;

constexpr std::string_view certificates_task = "certificates\n";

/// Points for each thread: of a hundredth of a second or so, against which messages cost nothing.
std::size_t batch_for_a_thread(int least_bits) { return least_bits > bits_of_doubles ? 2 : 64; }

void visit_number(auto& visit, auto& number) {
  visit_all(visit, number.decimal, number.value, number.exponent, number.is_squared, number.is_negative,
            number.is_cosine_of_degrees);
  visit_each(visit, number.divided_by_norm_of, [](auto& v, auto& part) { visit_number(v, part); });
}

void visit_form(auto& visit, auto& form) {
  visit_each(visit, form.terms, [](auto& v, auto& term) {
    v(term.unknown);
    visit_number(v, term.coefficient);
  });
  visit_number(visit, form.constant);
}

void visit_equation(auto& visit, auto& equation) {
  visit_each(visit, equation.products, [](auto& v, auto& product) {
    visit_form(v, product.left);
    visit_form(v, product.right);
  });
  visit_number(visit, equation.given);
}

void visit_certificate(auto& visit, auto& c) {
  visit_all(visit, c.is_proven, c.cluster, c.is_multiple, c.bits, c.enclosure.mid, c.enclosure.radius,
            c.enclosure.unique, c.realness, c.cause);
}

std::string to_task(const QuadraticSystem& system, int threads, int least_bits) {
  MessageWriter write;
  write.message = certificates_task;
  visit_all(write, threads, least_bits);
  write(system.unknowns);
  visit_each(write, system.equations, [](auto& v, auto& equation) { visit_equation(v, equation); });
  write(std::vector<SignMask>(system.mirror.begin(), system.mirror.end()));
  return std::move(write.message);
}

QuadraticSystem read_system(MessageReader& read) {
  QuadraticSystem system;
  read(system.unknowns);
  visit_each(read, system.equations, [](auto& v, auto& equation) { visit_equation(v, equation); });
  std::vector<SignMask> masks;
  read(masks);
  system.mirror = SignMasks(std::move(masks));
  return system;
}

std::string to_message(std::size_t first, std::size_t last, const PointOf& point_of) {
  MessageWriter write;
  write(last - first);
  for (std::size_t i = first; i < last; ++i) write(point_of(i));
  return std::move(write.message);
}

std::vector<Point> read_points(std::string_view message) {
  MessageReader read(message);
  std::vector<Point> points;
  visit_each(read, points, [](auto& v, auto& point) { v(point); });
  return points;
}

std::string to_message(const std::vector<Certificate>& certificates) {
  MessageWriter write;
  visit_each(write, certificates, [](auto& v, auto& certificate) { visit_certificate(v, certificate); });
  return std::move(write.message);
}

/// Reports from any thread how much is certified.
class CertificateProgress {
 public:
  CertificateProgress(Monitor* monitor, std::size_t all) : monitor_(monitor), all_(all) {}

  void one_more() {
    const std::lock_guard lock(mutex_);
    reach(++done_);
  }
  /// By one thread at a time.
  void reach(std::size_t done) const {
    if (monitor_ != nullptr)
      monitor_->progress("proving solutions", static_cast<double>(done) / static_cast<double>(all_));
  }

 private:
  Monitor* monitor_;
  std::size_t all_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

void certify_here(const Certifier& certifier, std::size_t points, const PointOf& point_of, int least_bits,
                  int threads, const std::stop_token& stop, const TakeCertificate& take) {
  share_on_threads(points, threads, [&](std::size_t i) {
    if (!stop.stop_requested()) take(i, certifier.certify(point_of(i), least_bits));
  });
}

/// What becomes of an item.
std::string certified(const Certifier& certifier, const std::string& item, int least_bits, int threads,
                      const std::stop_token& stop) {
  const std::vector<Point> points = read_points(item);
  std::vector<Certificate> certificates(points.size());
  certify_here(
      certifier, points.size(), [&](std::size_t i) { return points[i]; }, least_bits, threads, stop,
      [&](std::size_t i, Certificate certificate) { certificates[i] = std::move(certificate); });
  return to_message(certificates);
}

void certify_by_crew(const Certifier& certifier, std::size_t points, const PointOf& point_of,
                     const ProofSetup& setup, const TakeCertificate& take, int least_bits) {
  const int threads = setup.crew->threads_of_member(setup.threads);
  const std::size_t batch = batch_for_a_thread(least_bits) * static_cast<std::size_t>(threads);
  const std::size_t items = (points + batch - 1) / batch;
  const auto item_of = [&](std::size_t item) {
    return to_message(item * batch, std::min((item + 1) * batch, points), point_of);
  };
  const CertificateProgress handed_out(setup.monitor, items);
  OneByOne here([&](const NumberedItem& item) {
    handed_out.reach(item.number);
    return certified(certifier, item.bytes, least_bits, threads, setup.stop);
  });
  const auto take_result = [&](const NumberedItem& result) {
    std::vector<Certificate> some;
    MessageReader read(result.bytes);
    visit_each(read, some, [](auto& v, auto& certificate) { visit_certificate(v, certificate); });
    std::size_t number = result.number * batch;
    for (Certificate& certificate : some)
      if (const std::size_t i = number++; certificate.is_tried()) take(i, std::move(certificate));
  };
  setup.crew->each_result(
      to_task(certifier.system(), threads, least_bits), items, item_of, here,
      [&] { return setup.stop.stop_requested(); }, take_result);
}

}  // namespace

void certify_points(const Certifier& certifier, std::size_t points, const PointOf& point_of,
                    const ProofSetup& setup, const TakeCertificate& take, int least_bits) {
  if (setup.crew != nullptr && points > batch_for_a_thread(least_bits))
    return certify_by_crew(certifier, points, point_of, setup, take, least_bits);
  CertificateProgress progress(setup.monitor, points);
  certify_here(certifier, points, point_of, least_bits, setup.threads, setup.stop,
               [&](std::size_t i, Certificate certificate) {
                 take(i, std::move(certificate));
                 progress.one_more();
               });
}

std::unique_ptr<ItemWork> begin_certificates(const std::string& task) {
  if (!task.starts_with(certificates_task)) return nullptr;
  MessageReader read(std::string_view(task).substr(certificates_task.size()));
  int threads = 1, least_bits = bits_of_doubles;
  visit_all(read, threads, least_bits);
  const auto certifier = std::make_shared<const Certifier>(read_system(read));
  return std::make_unique<OneByOne>(
      [=](const NumberedItem& item) { return certified(*certifier, item.bytes, least_bits, threads, {}); });
}

}  // namespace gcs
