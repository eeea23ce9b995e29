// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/network.h"

#include "surrogate/cross_validation.h"

#include <doublefann.h>

#include <cmath>
#include <numeric>
#include <random>

namespace encased_column {

namespace {

constexpr int members = 5;
constexpr int rounds = 60, epochs = 10;  // looked at after each round
constexpr int patience = 12;             // rounds without a better one

struct FreeNetwork {
  void operator()(fann* network) const { fann_destroy(network); }
};
using Network = std::unique_ptr<fann, FreeNetwork>;
struct FreeTraining {
  void operator()(fann_train_data* data) const { fann_destroy_train(data); }
};
using Training = std::unique_ptr<fann_train_data, FreeTraining>;

/// Points from -1 to 1, values of mean 0 and spread 1.
struct Scale {
  double mean, spread;
};

class NetworkSurrogate : public Surrogate {
 public:
  NetworkSurrogate(std::vector<Network> networks, Scale scale)
      : networks_(std::move(networks)),
        scale_(scale)
  {
  }
  double value(const Eigen::VectorXd& point) const override
  {
    Eigen::VectorXd input = 2.0 * point.array() - 1.0;
    double sum = 0.0;
    for (const Network& one : networks_) sum += fann_run(one.get(), input.data())[0];
    return scale_.mean + scale_.spread * sum / static_cast<double>(networks_.size());
  }

 private:
  std::vector<Network> networks_;
  Scale scale_;
};

Training training(const Data& data, const Scale& scale)
{
  const auto inputs = static_cast<unsigned>(data.points.cols());
  Training result(fann_create_train(static_cast<unsigned>(data.size()), inputs, 1));
  for (Eigen::Index n = 0; n < data.size(); ++n) {
    for (unsigned i = 0; i < inputs; ++i) result->input[n][i] = 2.0 * data.points(n, i) - 1.0;
    result->output[n][0] = (data.values[n] - scale.mean) / scale.spread;
  }
  return result;
}

/// Weights from the uniform distribution with which neither layer saturates (Glorot and Bengio,
/// 2010); the library's own would come from a generator that all of the program shares.
Network new_network(unsigned inputs, std::mt19937& random)
{
  Network network(fann_create_standard(3, inputs, network_neurons, 1U));
  fann_set_activation_function_hidden(network.get(), FANN_SIGMOID_SYMMETRIC);
  fann_set_activation_function_output(network.get(), FANN_LINEAR);
  fann_set_activation_steepness_hidden(network.get(), 1.0);
  fann_set_activation_steepness_output(network.get(), 1.0);
  fann_set_training_algorithm(network.get(), FANN_TRAIN_RPROP);
  const double most = std::sqrt(6.0 / (inputs + network_neurons));
  std::vector<fann_connection> connections(fann_get_total_connections(network.get()));
  fann_get_connection_array(network.get(), connections.data());
  for (fann_connection& one : connections)
    one.weight = most * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
  fann_set_weight_array(network.get(), connections.data(),
                        static_cast<unsigned>(connections.size()));
  return network;
}

Network train(Network network, fann_train_data* learnt, fann_train_data* left_out)
{
  Network best(fann_copy(network.get()));
  double least = HUGE_VAL;
  for (int round = 0, waited = 0; round < rounds && waited < patience; ++round, ++waited) {
    for (int epoch = 0; epoch < epochs; ++epoch) fann_train_epoch(network.get(), learnt);
    const double error = static_cast<double>(fann_test_data(network.get(), left_out));
    if (!(error < least)) continue;
    least = error;
    waited = -1;
    best.reset(fann_copy(network.get()));
  }
  return best;
}

}  // namespace

std::unique_ptr<Surrogate> fit_network(const Data& data, unsigned seed)
{
  std::mt19937 random(seed);
  Scale scale{data.values.mean(), 1.0};
  const double spread = std::sqrt((data.values.array() - scale.mean).square().mean());
  if (spread > 1e-12 * std::abs(scale.mean)) scale.spread = spread;
  std::vector<Network> networks;
  for (const Fold& fold : folds_of(data.groups, members, seed)) {
    Network network = new_network(static_cast<unsigned>(data.points.cols()), random);
    networks.push_back(train(std::move(network), training(data.rows(fold.learnt), scale).get(),
                             training(data.rows(fold.left_out), scale).get()));
  }
  return std::make_unique<NetworkSurrogate>(std::move(networks), scale);
}

}  // namespace encased_column
