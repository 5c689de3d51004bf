#pragma once
/// Vectors and matrices of complex balls of the library Arb (Johansson, Arb: efficient arbitrary-precision
/// midpoint-radius interval arithmetic, IEEE Trans. Comput. 66, 2017): every operation encloses its exact
/// result.

#include <acb.h>
#include <acb_mat.h>

#include <complex>

#include "solvers/numeric/exact_number.hpp"

namespace gcs {

class Ball {
 public:
  Ball() { acb_init(value_); }
  ~Ball() { acb_clear(value_); }
  Ball(const Ball&) = delete;
  Ball& operator=(const Ball&) = delete;

  operator acb_ptr() { return value_; }           // NOLINT(google-explicit-constructor): Arb's functions
  operator acb_srcptr() const { return value_; }  // NOLINT(google-explicit-constructor): take these

 private:
  acb_t value_;
};

class BallMatrix {
 public:
  BallMatrix(slong rows, slong columns) { acb_mat_init(value_, rows, columns); }
  BallMatrix(const BallMatrix& other) : BallMatrix(other.rows(), other.columns()) {
    acb_mat_set(value_, other.value_);
  }
  BallMatrix& operator=(const BallMatrix& other) {
    acb_mat_set(value_, other.value_);
    return *this;
  }
  ~BallMatrix() { acb_mat_clear(value_); }

  slong rows() const { return acb_mat_nrows(value_); }
  slong columns() const { return acb_mat_ncols(value_); }
  acb_ptr operator()(slong row, slong column) { return acb_mat_entry(value_, row, column); }
  acb_srcptr operator()(slong row, slong column) const { return acb_mat_entry(value_, row, column); }
  acb_mat_struct* get() { return value_; }
  const acb_mat_struct* get() const { return value_; }

 private:
  acb_mat_t value_;
};

/// A ball that holds the number, as small as `bits` allow.
void enclose(acb_ptr ball, const ExactNumber& number, slong bits);

/// The ball's middle, rounded to doubles.
std::complex<double> rounded_midpoint(acb_srcptr ball);

/// At least |x| for all x of the ball: a double, rounded up.
double magnitude(acb_srcptr ball);
/// At most |x| for all x of the ball.
double least_magnitude(acb_srcptr ball);

}  // namespace gcs
