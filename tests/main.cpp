#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#define RIGLESS_DEFINE_NEW
#include "support/alloc_count.h"
