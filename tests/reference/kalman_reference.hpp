// The Kalman filter as the textbook has it (Bar-Shalom, Li and Kirubarajan 2001, §5.2.4 and §6.2.2): six
// states, dense matrices, the gain by an inverse, the covariance in its plain form. Slow, and independent of
// the filter that flies.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace mayfly::reference {

class Matrix {
 public:
  Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), values_(rows * columns) {}
  static Matrix identity(std::size_t size) {
    Matrix m(size, size);
    for (std::size_t i = 0; i < size; ++i) {
      m(i, i) = 1.0;
    }
    return m;
  }
  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  double& operator()(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }
  double operator()(std::size_t row, std::size_t column) const { return values_[row * columns_ + column]; }

  Matrix transposed() const {
    Matrix t(columns_, rows_);
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j < columns_; ++j) {
        t(j, i) = (*this)(i, j);
      }
    }
    return t;
  }
  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix product(a.rows(), b.columns());
    for (std::size_t i = 0; i < a.rows(); ++i) {
      for (std::size_t j = 0; j < b.columns(); ++j) {
        for (std::size_t k = 0; k < a.columns(); ++k) {
          product(i, j) += a(i, k) * b(k, j);
        }
      }
    }
    return product;
  }
  friend Matrix sum(const Matrix& a, const Matrix& b, double factor = 1.0) {
    Matrix total = a;
    for (std::size_t i = 0; i < a.values_.size(); ++i) {
      total.values_[i] += factor * b.values_[i];
    }
    return total;
  }
  // Gauss and Jordan, with pivots.
  Matrix inverse() const {
    Matrix left = *this;
    Matrix right = identity(rows_);
    for (std::size_t c = 0; c < rows_; ++c) {
      std::size_t pivot = c;
      for (std::size_t r = c + 1; r < rows_; ++r) {
        pivot = std::fabs(left(r, c)) > std::fabs(left(pivot, c)) ? r : pivot;
      }
      for (std::size_t j = 0; j < rows_; ++j) {
        std::swap(left(c, j), left(pivot, j));
        std::swap(right(c, j), right(pivot, j));
      }
      const double scale = left(c, c);
      for (std::size_t j = 0; j < rows_; ++j) {
        left(c, j) /= scale;
        right(c, j) /= scale;
      }
      for (std::size_t r = 0; r < rows_; ++r) {
        const double factor = r == c ? 0.0 : left(r, c);
        for (std::size_t j = 0; j < rows_; ++j) {
          left(r, j) -= factor * left(c, j);
          right(r, j) -= factor * right(c, j);
        }
      }
    }
    return right;
  }

 private:
  std::size_t rows_, columns_;
  std::vector<double> values_;
};

// State: x, y, z, vx, vy, vz.
struct KalmanReference {
  Matrix x{6, 1};
  Matrix p{6, 6};

  void begin(const std::array<double, 3>& position, double position_variance,
             const std::array<double, 3>& velocity, double velocity_variance) {
    for (std::size_t i = 0; i < 3; ++i) {
      x(i, 0) = position[i];
      x(i + 3, 0) = velocity[i];
      p(i, i) = position_variance;
      p(i + 3, i + 3) = velocity_variance;
    }
  }

  void predict(double t, double density) {
    Matrix f = Matrix::identity(6);
    Matrix q(6, 6);
    for (std::size_t i = 0; i < 3; ++i) {
      f(i, i + 3) = t;
      q(i, i) = density * t * t * t / 3.0;
      q(i, i + 3) = q(i + 3, i) = density * t * t / 2.0;
      q(i + 3, i + 3) = density * t;
    }
    x = f * x;
    p = sum(f * p * f.transposed(), q);
  }

  // `h` picks the states that were measured: 3 or 6 rows.
  void correct(const Matrix& h, const Matrix& z, const Matrix& r) {
    const Matrix s = sum(h * p * h.transposed(), r);
    const Matrix gain = p * h.transposed() * s.inverse();
    x = sum(x, gain * sum(z, h * x, -1.0));
    p = sum(Matrix::identity(6), gain * h, -1.0) * p;
  }
};

}  // namespace mayfly::reference
