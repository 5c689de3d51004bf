#include "solvers/tests/laman_graphs.hpp"

namespace gcs::samples {

const std::vector<RecordGraph> record_graphs{{6, 7916, 24},
                                             {7, 1269995, 56},
                                             {8, 170989214, 136},
                                             {9, 11177989553, 344},
                                             {10, 4778440734593, 880},
                                             {11, 18120782205838348, 2288},
                                             {12, 252590061719913632, 6180}};

}  // namespace gcs::samples
