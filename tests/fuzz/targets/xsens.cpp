#include "tests/fuzz/stream_checks.hpp"

ABRAZO_FUZZ_TARGET(xsens)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::receive("xsens://0.0.0.0:9763", bytes);
}
