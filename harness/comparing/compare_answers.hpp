#pragma once
/// Two answers to one question held against each other: status, claim, counts, proofs and accuracy.

#include <string>
#include <vector>

#include "harness/runs/run_file.hpp"

namespace gcs {

/// Something that both runs say, and differently; in words.
struct Changed {
  std::string what;
  std::string before;
  std::string after;
};

enum class ChangeVerdict { better, worse, different };

/// A count, a status, a claim, a proof or an accuracy of one cell.
struct AnswerChange {
  CellSpec cell;
  Changed changed;
  ChangeVerdict verdict = ChangeVerdict::different;
};

/// What differs between two measurements of one cell. Worse is: a status further from an answer, a weaker
/// claim, fewer solutions found or proven, more paths lost, solutions missed or spurious, an error that the
/// condition does not explain any more. Better is the reverse; what is neither, such as the number of paths,
/// is different, and so is any count beside a wrong answer's. Accuracy is compared where both were held
/// against one reference.
std::vector<AnswerChange> compare_answers(const CellRecord& before, const CellRecord& after,
                                          bool have_one_reference);

}  // namespace gcs
