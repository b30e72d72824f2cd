#pragma once

#include <semaphore.h>

/// In a library of its own, as a graphics driver is: waits until the semaphore is raised.
void wait_in_driver(sem_t* drawn);
