#include "tests/bench/umfpack_solver.hpp"

#include <dlfcn.h>
#include <suitesparse/umfpack.h>

#include <array>

extern "C" void dgemm_();  // only its address is asked for

namespace abrazo::bench {

namespace {

class UmfpackSolver : public KktSolver {
 public:
  explicit UmfpackSolver(Ordering ordering) : ordering_(ordering) {
    umfpack_di_defaults(control_.data());
    control_[UMFPACK_IRSTEP] = 0;
  }
  ~UmfpackSolver() override { umfpack_di_free_symbolic(&symbolic_); }
  UmfpackSolver(const UmfpackSolver&) = delete;
  UmfpackSolver& operator=(const UmfpackSolver&) = delete;

  bool solve(const KktSystem& system, std::vector<double>& solution) override {
    if (!analyse(system)) return false;
    void* numeric = nullptr;
    const int done = umfpack_di_numeric(system.column_starts.data(), system.rows.data(), system.values.data(),
                                        symbolic_, &numeric, control_.data(), nullptr);
    if (done == UMFPACK_OK) {
      solution.resize(static_cast<std::size_t>(system.size));
      change_.resize(solution.size());
      back_substitute(system, numeric, system.right, solution);
      refinement_side(system, solution, right_);
      back_substitute(system, numeric, right_, change_);
      for (std::size_t i = 0; i < solution.size(); ++i) solution[i] += change_[i];
    }
    umfpack_di_free_numeric(&numeric);
    return done == UMFPACK_OK;
  }

 private:
  bool analyse(const KktSystem& system) {
    if (symbolic_ != nullptr && ordering_ == Ordering::Reused && system.column_starts == starts_ &&
        system.rows == rows_)
      return true;
    umfpack_di_free_symbolic(&symbolic_);
    if (ordering_ == Ordering::Reused) {
      starts_ = system.column_starts;
      rows_ = system.rows;
    }
    return umfpack_di_symbolic(system.size, system.size, system.column_starts.data(), system.rows.data(),
                               system.values.data(), &symbolic_, control_.data(), nullptr) == UMFPACK_OK;
  }
  void back_substitute(const KktSystem& system, void* numeric, const std::vector<double>& right,
                       std::vector<double>& solution) const {
    umfpack_di_solve(UMFPACK_A, system.column_starts.data(), system.rows.data(), system.values.data(),
                     solution.data(), right.data(), numeric, control_.data(), nullptr);
  }

  Ordering ordering_;
  std::array<double, UMFPACK_CONTROL> control_{};
  void* symbolic_ = nullptr;
  std::vector<int> starts_, rows_;
  std::vector<double> right_, change_;
};

}  // namespace

std::unique_ptr<KktSolver> umfpack_solver(Ordering ordering) {
  return std::make_unique<UmfpackSolver>(ordering);
}

std::string umfpack_version() {
  Dl_info where{};
  const bool known = dladdr(reinterpret_cast<void*>(&dgemm_), &where) != 0 && where.dli_fname != nullptr;
  return std::string(UMFPACK_VERSION) + ", BLAS " + (known ? where.dli_fname : "unknown");
}

}  // namespace abrazo::bench
