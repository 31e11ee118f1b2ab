// Writes docs/reference/fault-table.md: mayfly_fault_table_gen TOP
#include <fstream>
#include <iostream>
#include <string>

#include "controller/safety/reaction_table.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: mayfly_fault_table_gen TOP_OF_THE_TREE\n";
    return 2;
  }
  const std::string path = std::string(arguments[1]) + "/docs/reference/fault-table.md";
  std::ofstream file(path);
  file << mayfly::fault_table_page();
  if (!file.flush()) {
    std::cerr << "cannot write " << path << '\n';
    return 1;
  }
  return 0;
}
