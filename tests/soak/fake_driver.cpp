#include "tests/soak/fake_driver.hpp"

void wait_in_driver(sem_t* drawn) {
  while (::sem_wait(drawn) != 0) {
  }
}
