"""The simulator's side: the scene, its cases, batched rollouts and what is recorded of them."""
