# All projects of plugins in folders beside this, each built in its own folder as if it stood alone.
cmake_minimum_required(VERSION 3.25)
project(plugins LANGUAGES CXX)
enable_testing()
file(GLOB scenes */scene.json)
foreach(scene IN LISTS scenes)
  get_filename_component(folder ${scene} DIRECTORY)
  add_subdirectory(${folder} ${folder}/build)
endforeach()
